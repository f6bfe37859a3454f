// SPDX-License-Identifier: MIT
#include "pipeline/products/kinematics.h"

#include "derive/kinematics/forward_kinematics.h"
#include "emit/cpp/leaf_names.h"
#include "emit/math/closed_form.h"
#include "emit/render.h"
#include "optimise/optimised_json.h"
#include "verify/accuracy.h"
#include "verify/counts_json.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr int accuracy_points = 200;

json temporaries(const emit::Code& code) {
  json list = json::array();
  for (const auto& value : code.temporaries)
    list.push_back({{"name", value.name}, {"expression", value.expression}});
  return list;
}

/// What the head of a function says: counts, certificate, rounding error.
std::string notes(const optimise::Optimised& optimised) {
  return "/// " + verify::describe(optimised.counts) +
         ". Equal to the plain product of the joints' pairs at " +
         std::to_string(optimised.certified_points) +
         " random\n/// exact points, tolerance zero; largest rounding error found " +
         to_json(optimised).at("largest_error_ulp").dump() + " ulp.\n///";
}

optimise::Optimised optimise_with_accuracy(const derive::Quantity& quantity,
                                           const std::vector<verify::OutputGroup>& groups) {
  optimise::Optimised optimised = optimise::optimise(quantity);
  optimised.largest_error = verify::largest_error_in_ulps(optimised.function, groups, accuracy_points);
  return optimised;
}

void add_pose(const model::Robot& robot, const optimise::Optimised& pose, json& values) {
  const auto angles = emit::angles_of(pose.function);
  const emit::Names names = emit::leaf_names(robot, angles);
  const emit::Code code = emit::cpp_code(pose.function, names);
  values["pose_notes"] = notes(pose);
  values["pose_angles"] = emit::angle_values(angles, names);
  values["pose_angle_count"] = angles.size();
  values["pose_sines_cosines"] = sines_cosines_code(angles, names, "PoseAngles");
  values["pose_temporaries"] = temporaries(code);
  for (const auto& output : code.outputs) values[output.name] = output.expression;
}

void add_transform(const model::Robot& robot, const optimise::Optimised& transform, json& values) {
  const auto angles = emit::angles_of(transform.function);
  const emit::Names names = emit::leaf_names(robot, angles);
  const emit::Code code = emit::cpp_code(transform.function, names);
  values["transform_notes"] = notes(transform);
  values["transform_angles"] = emit::angle_values(angles, names);
  values["transform_angle_count"] = angles.size();
  values["transform_sines_cosines"] = sines_cosines_code(angles, names, "TransformAngles");
  values["transform_temporaries"] = temporaries(code);
  values["transform_entries"] = json::array();
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    values["transform_entries"].push_back({{"row", i < 9 ? i / 3 : i - 9},
                                           {"column", i < 9 ? i % 3 : 3},
                                           {"expression", code.outputs[i].expression}});
}

}  // namespace

void generate_kinematics(const model::Robot& robot, RobotOutput& output) {
  const verify::OutputGroup position{"px", "py", "pz"};
  const optimise::Optimised pose =
      optimise_with_accuracy(derive::forward_kinematics(robot), {{"w", "x", "y", "z"}, position});
  const optimise::Optimised transform =
      optimise_with_accuracy(derive::homogeneous_transform(robot),
                             {{"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"}, position});
  json values{{"name", robot.name}, {"scalars", {{{"scalar", "double"}}, {{"scalar", "float"}}}}};
  add_pose(robot, pose, values);
  add_transform(robot, transform, values);
  values["closed_form"] = json::array();
  for (const std::string& line : emit::closed_form_lines(robot, emit::Notation::text))
    values["closed_form"].push_back({{"line", line}});
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + "kinematics.h", emit::render("kinematics.h", values)});
  output.files.push_back(
      {headers + "kinematics_definitions.h", emit::render("kinematics_definitions.h", values)});
  output.files.push_back(
      {"source/" + robot.name + "/kinematics.cpp", emit::render("kinematics.cpp", values)});
  output.counts[pose.name] = to_json(pose);
  output.counts[transform.name] = to_json(transform);
}

}  // namespace qvgen::pipeline
