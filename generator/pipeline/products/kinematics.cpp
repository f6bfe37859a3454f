// SPDX-License-Identifier: MIT
#include "pipeline/products/kinematics.h"

#include "canonical/right_angles.h"
#include "derive/kinematics/forward_kinematics.h"
#include "emit/c/parts.h"
#include "emit/cpp/angles.h"
#include "emit/cpp/printer.h"
#include "emit/cpp/scalars.h"
#include "emit/leaves.h"
#include "emit/math/closed_form.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "optimise/described.h"
#include "optimise/optimised_json.h"
#include "optimise/pose.h"
#include "pipeline/c_files.h"
#include "pipeline/images.h"
#include "verify/accuracy.h"
#include "verify/counts_json.h"
#include "verify/same_pose.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr int accuracy_points = 200;

/// Returns the notes in the head of a function: counts, certificate, rounding error.
std::string notes(const optimise::Optimised& optimised) {
  return "/// " + verify::describe(optimised.counts) +
         ". Equal to the plain product of the joints' pairs at " +
         std::to_string(optimised.certified_points) +
         " random\n/// exact points, tolerance zero; largest rounding error found " +
         to_json(optimised).at("largest_error_ulp").dump() + " ulp.\n///";
}

optimise::Optimised with_accuracy(const canonical::Arm& arm, optimise::Optimised optimised,
                                  const std::vector<verify::OutputGroup>& groups) {
  optimised.largest_error = verify::largest_error_in_ulps(optimised.function, groups, accuracy_points);
  return optimise::in_terms_of_description(std::move(optimised), arm);
}

/// Template values of a function, whose keys begin with `prefix`; returns its code.
emit::Code add_function(const model::Robot& robot, const optimise::Optimised& optimised,
                        const std::string& prefix, const std::string& angles_type, json& values) {
  const auto angles = emit::angles_of(optimised.function);
  const emit::ast::Leaves leaves = emit::robot_leaves(robot, angles);
  emit::Code code = emit::straight_code(optimised.function, leaves, emit::plain_cpp());
  values[prefix + "notes"] = notes(optimised);
  values[prefix + "angles"] = emit::angle_values(angles, leaves);
  values[prefix + "angle_count"] = angles.size();
  values[prefix + "sines_cosines"] = emit::sines_cosines_code(angles, leaves, angles_type);
  values[prefix + "named_angles"] =
      emit::lines_of(emit::sine_cosine_declarations(robot, optimised.function, angles));
  values[prefix + "temporaries"] = emit::values_of(code.temporaries);
  return code;
}

void add_pose(const model::Robot& robot, const optimise::Optimised& pose, json& values) {
  const emit::Code code = add_function(robot, pose, "pose_", "PoseAngles", values);
  for (const auto& output : code.outputs) values[output.name] = output.expression;
}

void add_transform(const model::Robot& robot, const optimise::Optimised& transform, json& values) {
  const emit::Code code = add_function(robot, transform, "transform_", "TransformAngles", values);
  values["transform_entries"] = json::array();
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    values["transform_entries"].push_back({{"row", i < 9 ? i / 3 : i - 9},
                                           {"column", i < 9 ? i % 3 : 3},
                                           {"expression", code.outputs[i].expression}});
}

/// The functions, certified; their counts go to the output.
struct Kinematics {
  model::Robot robot;
  optimise::Optimised pose;
  optimise::Optimised transform;
};

Kinematics kinematics_of(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::whatever_notation(described);
  verify::certify_same_pose(described, arm);
  optimise::Pose pose = optimise::forward_kinematics(described);
  const verify::OutputGroup position{"px", "py", "pz"};
  Kinematics found{
      arm.robot, with_accuracy(pose.arm, std::move(pose.function), {{"w", "x", "y", "z"}, position}),
      with_accuracy(arm, optimise::optimise(derive::homogeneous_transform(arm.robot)),
                    {{"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"}, position})};
  for (const optimise::Optimised* each : {&found.pose, &found.transform})
    output.counts[each->name] = to_json(*each);
  return found;
}

/// Bytes of formulas that somebody reads: more than those of seven joints turned anyhow.
constexpr std::size_t longest_closed_form = 10000;

/// The closed form as lines of a comment, or where to find one that is too long for it.
std::vector<std::string> closed_form_comment(const model::Robot& described) {
  std::vector<std::string> lines =
      emit::closed_form_lines(described, emit::Notation::text.with(emit::Numbers::exact));
  std::size_t bytes = 0;
  for (const std::string& line : lines) bytes += line.size();
  if (bytes > longest_closed_form) return {"`qvgen show` prints the closed form, which is long."};
  return lines;
}

}  // namespace

void generate_kinematics(const model::Robot& described, RobotOutput& output) {
  const auto [robot, pose, transform] = kinematics_of(described, output);
  json values{{"name", robot.name}, {"scalars", emit::scalars()}};
  add_pose(robot, pose, values);
  add_transform(robot, transform, values);
  values["closed_form"] = emit::lines_of(closed_form_comment(described));
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + "kinematics.h", emit::render("cpp/kinematics.h", values)});
  output.files.push_back(
      {headers + "kinematics_definitions.h", emit::render("cpp/kinematics_definitions.h", values)});
  output.files.push_back(
      {"source/" + robot.name + "/kinematics.cpp", emit::render("cpp/kinematics.cpp", values)});
  for (const model::Image& image : output.images)
    add_image(described, image, "kinematics", true, values, output);
}

void generate_kinematics_c(const model::Robot& described, RobotOutput& output) {
  const auto [robot, pose, transform] = kinematics_of(described, output);
  add_c_part(output, emit::c::pose(robot, pose,
                                   {"Pose of the tool in the world frame: unit quaternion and position.", "",
                                    verify::describe(pose.counts) + "."}));
  add_c_part(output, emit::c::transform(robot, transform,
                                        {"The same as a homogeneous transformation.", "",
                                         verify::describe(transform.counts) + "."}));
}

}  // namespace qvgen::pipeline
