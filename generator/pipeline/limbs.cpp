// SPDX-License-Identifier: MIT
#include "pipeline/limbs.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "emit/render.h"
#include "model/coordinates.h"
#include "model/followers.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// Returns where a limb's variable comes from: the whole robot's motor of that name, or those that move the
/// joint of that name.
std::vector<model::Share> shares_of(const model::Robot& robot, const std::string& variable) {
  const std::vector<std::string> motors = model::variables(robot);
  const auto motor = std::find(motors.begin(), motors.end(), variable);
  if (motor != motors.end()) return {{static_cast<std::size_t>(motor - motors.begin()), 1}};
  const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const model::Joint& each) { return each.variable == variable; });
  return model::shares(robot)[static_cast<std::size_t>(joint - robot.joints.begin())];
}

/// The places of a limb's joints among all velocities, behind those of a floating base.
json columns_of(const model::Robot& robot, const json& joints) {
  std::set<std::size_t> columns;
  const std::size_t base = model::base_motions(robot);
  for (std::size_t k = 0; k < base; ++k) columns.insert(k);
  for (const json& joint : joints) columns.insert(base + joint.at("joint").get<std::size_t>());
  json list = json::array();
  for (const std::size_t column : columns)
    list.push_back({{"column", column}, {"last", column == *columns.rbegin()}});
  return list;
}

/// How the functions of tips are told where the robot is: by a base that floats, or by joints alone.
json names_of_configuration(const model::Robot& robot) {
  if (robot.floating_base)
    return {{"configuration", "Configuration"}, {"velocity", "Velocity"}, {"size", "velocity_size"},
            {"before_pose", "at.base * "},      {"joints_at", "at.q"},    {"tip_function", "floating_tip"}};
  return {{"configuration", "JointVector"},
          {"velocity", "JointVector"},
          {"size", "dof"},
          {"before_pose", ""},
          {"joints_at", "at"},
          {"tip_function", "fixed_tip"}};
}

}  // namespace

std::vector<model::Robot> limbs_of(const model::Mechanism& mechanism) {
  std::vector<model::Robot> limbs;
  for (const model::Frame& tip : mechanism.tips) {
    limbs.push_back(model::limb(mechanism.robot, tip));
    for (model::Joint& joint : limbs.back().joints) {
      joint.inertia = {};
      joint.drive = {};
    }
    for (model::Motor& motor : limbs.back().motors) motor.drive = {};
    limbs.back().inertia_parameters.clear();
  }
  return limbs;
}

json joints_of_limb(const model::Robot& robot, const model::Robot& limb) {
  json list = json::array();
  const std::vector<std::string> variables = model::variables(limb);
  for (std::size_t place = 0; place < variables.size(); ++place)
    for (const model::Share& share : shares_of(robot, variables[place]))
      list.push_back({{"place", place},
                      {"joint", share.driven},
                      {"ratio", fmt::format("{}", cln::double_approx(share.ratio))},
                      {"last", false}});
  list.back()["last"] = true;
  return list;
}

void add_limbs(const model::Mechanism& mechanism, RobotOutput& output) {
  const std::vector<model::Robot> limbs = limbs_of(mechanism);
  json values{{"name", mechanism.robot.name}, {"limbs", json::array()}};
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const json joints = joints_of_limb(mechanism.robot, limbs[i]);
    const std::size_t count = model::driven_count(limbs[i]);
    values["limbs"].push_back({{"tip", mechanism.tips[i].name},
                               {"limb", limbs[i].name},
                               {"joint_count", count},
                               {"share_count", joints.size()},
                               {"has_sums", joints.size() != count},
                               {"joints", joints},
                               {"columns", columns_of(mechanism.robot, joints)},
                               {"last", i + 1 == limbs.size()}});
    json& limb = values["limbs"].back();
    limb["column_count"] = limb["columns"].size();
  }
  output.files.push_back(
      {"include/qvgen/robots/" + mechanism.robot.name + "/limbs.h", emit::render("cpp/limbs.h", values)});
  values["tip_count"] = limbs.size();
  values.update(names_of_configuration(mechanism.robot));
  output.files.push_back(
      {"include/qvgen/robots/" + mechanism.robot.name + "/tips.h", emit::render("cpp/tips.h", values)});
}

}  // namespace qvgen::pipeline
