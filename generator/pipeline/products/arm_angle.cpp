// SPDX-License-Identifier: MIT
#include "pipeline/products/arm_angle.h"

#include <qvgen/inverse/arm_angle.h>

#include "canonical/arm.h"
#include "derive/inverse/spherical_arm.h"
#include "emit/cpp/inverse/arm_angle_code.h"
#include "emit/render.h"
#include "exact/named_constant.h"
#include "model/followers.h"
#include "model/private_names.h"
#include "model/replace.h"
#include "verify/inverse/certify_rows.h"
#include "verify/inverse/definition.h"
#include "verify/inverse/execute.h"

namespace qvgen::pipeline {
namespace {

using derive::inverse::SphericalArm;

/// The arm that generated code hands to the runtime, in numbers.
inverse::arm_angle::Arm in_numbers(const SphericalArm& derived, const model::Bindings& geometry) {
  verify::Values values;
  for (const auto& [name, value] : geometry) values[name] = verify::Real(value);
  const verify::Values at = verify::outputs(derived.values, values);
  const auto number = [&](const std::string& name) { return at.at(name).to_double(); };
  const auto vector = [&](const std::string& name) {
    return Vector3<double>(number(name + "_x"), number(name + "_y"), number(name + "_z"));
  };
  inverse::arm_angle::Arm arm;
  for (std::size_t i = 0; i < arm.axes.size(); ++i) arm.axes[i] = vector("axis" + std::to_string(i + 1));
  arm.base = vector("base");
  arm.shoulder = vector("shoulder");
  arm.elbow = vector("elbow");
  arm.wrist = vector("wrist");
  arm.planar = derived.planar;
  arm.tool = {Eigen::Quaterniond(number("turn_w"), number("turn_x"), number("turn_y"), number("turn_z")),
              vector("place")};
  return arm;
}

/// Values of the symbols of a robot, and of the names that stand for what is made of them.
model::Bindings sampled_geometry(const model::Robot& robot) {
  model::Bindings geometry = model::sample_geometry(robot);
  for (const std::string& name : model::symbols(robot))
    if (const auto constant = exact::named_value(name)) geometry[name] = *constant;
  for (const auto& [name, definition] : robot.definitions)
    geometry[name] = model::evaluate(definition, geometry);
  return geometry;
}

/// By both references in turn. `robot` is `described` with its constants named.
verify::RowCertificate certify(const model::Robot& described, const model::Robot& robot,
                               const SphericalArm& derived) {
  constexpr int poses = 6;
  const model::Bindings geometry = sampled_geometry(robot);
  const inverse::arm_angle::Arm arm = in_numbers(derived, geometry);
  const double size = (arm.elbow - arm.shoulder).norm() + (arm.wrist - arm.elbow).norm() +
                      (arm.tool.position - arm.wrist).norm() + arm.shoulder.norm();
  bool stereographic = false;
  const auto solver = [&](const verify::PoseInDoubles& numbers, const std::vector<double>& sampled) {
    const Pose<double> pose{Eigen::Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]),
                            Vector3<double>(numbers[4], numbers[5], numbers[6])};
    stereographic = !stereographic;
    const ArmAngleReference reference =
        stereographic ? ArmAngleReference::stereographic() : ArmAngleReference::conventional();
    const double psi = inverse::arm_angle::arm_angle(arm, inverse::arm_angle::Row(sampled.data()), reference);
    std::vector<std::vector<double>> rows;
    for (const auto& row : inverse::arm_angle::solve(
             arm, pose, psi, reference, inverse::arm_angle::Row::Zero(), inverse::default_tolerance))
      rows.emplace_back(row.q.data(), row.q.data() + row.q.size());
    return rows;
  };
  return verify::certify_rows(described, geometry, size, solver, poses);
}

}  // namespace

void generate_arm_angle(const model::Robot& described, RobotOutput& output) {
  if (model::has_followers(described) || !derive::inverse::has_seven_turns(described)) return;
  const model::Robot with_names = model::with_private_names(described);
  const model::Robot robot = canonical::for_dynamics(with_names);
  const SphericalArm arm = derive::inverse::spherical_arm(robot);
  if (!arm.found) {
    output.missing.push_back({"arm_angle", Missing::Kind::not_derived, "no arm angle: " + arm.reason});
    return;
  }
  const nlohmann::json values{{"name", described.name},
                              {"certificate", certify(with_names, robot, arm).text()},
                              {"arm", emit::arm_angle_values(robot, arm)}};
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/arm_angle.h", emit::render("cpp/arm_angle.h", values)});
  output.files.push_back(
      {"source/" + described.name + "/arm_angle.cpp", emit::render("cpp/arm_angle.cpp", values)});
  // Not counted, but listed with the functions that are.
  for (const char* function : {"arm_angle", "inverse_kinematics_arm_angle", "arm_angle_intervals"})
    output.counts[function] = nlohmann::ordered_json::object();
}

void generate_arm_angle_c(const model::Robot& robot, RobotOutput& output) {
  if (model::has_followers(robot) || !derive::inverse::has_seven_turns(robot)) return;
  output.missing.push_back({"arm_angle", Missing::Kind::not_in_language,
                            "it is not written in C: its solver is a part of the C++ runtime"});
}

}  // namespace qvgen::pipeline
