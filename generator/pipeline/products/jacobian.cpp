// SPDX-License-Identifier: MIT
#include "pipeline/products/jacobian.h"

#include <map>

#include "canonical/right_angles.h"
#include "dag/import.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/wrist.h"
#include "emit/c/parts.h"
#include "emit/c/printer.h"
#include "emit/code.h"
#include "emit/cpp/angles.h"
#include "emit/cpp/printer.h"
#include "emit/cpp/scalars.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "optimise/described.h"
#include "optimise/optimised_json.h"
#include "passes/pass.h"
#include "pipeline/c_files.h"
#include "pipeline/images.h"
#include "pipeline/products/jacobian_functions.h"
#include "verify/certificate.h"
#include "verify/counts_json.h"
#include "verify/same_pose.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// Counts of the lecture's three methods, each certified by itself.
nlohmann::ordered_json methods(const model::Robot& robot) {
  const symbolic::Program definition = derive::jacobian(robot).definition;
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (const derive::Form& method : derive::jacobian_methods(robot)) {
    const dag::Function function = passes::simplify(dag::import(method.program));
    verify::certify(function, definition, 2, "jacobian by " + method.name);
    result[method.name] = verify::to_json(dag::count(function));
  }
  return result;
}

json measure_values(const emit::SingularityMeasures& measures) {
  json values = json::array();
  for (std::size_t i = 0; i < measures.names.size(); ++i)
    values.push_back({{"measure", measures.names[i]}, {"last", i + 1 == measures.names.size()}});
  return values;
}

/// The wrist centre in the tool frame, x, y and z, if there is one; nothing else.
std::vector<std::string> wrist_centre_code(const model::Robot& robot, const emit::ast::Printer& language) {
  const auto centre = derive::wrist_centre(robot);
  if (!centre) return {};
  symbolic::Program program;
  program.output("x", centre->x);
  program.output("y", centre->y);
  program.output("z", centre->z);
  std::vector<std::string> code;
  for (const auto& value :
       emit::straight_code(dag::import(program), emit::robot_leaves(robot, {}), language).outputs)
    code.push_back(value.expression);
  return code;
}

/// A list of one or none.
json wrist_values(const model::Robot& robot) {
  const std::vector<std::string> code = wrist_centre_code(robot, emit::plain_cpp());
  if (code.empty()) return json::array();
  return json::array({{{"x", code.at(0)}, {"y", code.at(1)}, {"z", code.at(2)}}});
}

/// Adds to the values how an image sees results, arguments and the wrist centre.
json as_seen(const model::Image& image, json values) {
  const std::map<std::string, std::string> results{{"Jacobian", "detail::Image::columns<Scalar>"},
                                                   {"Twist", "detail::Image::twist<Scalar>"},
                                                   {"TransformAndJacobian", "detail::seen<Scalar>"},
                                                   {"SingularityMeasures", ""}};
  for (json& function : values["functions"]) {
    function["seen"] = results.at(function["result"]);
    if (function["function"] == "tool_jacobian") function["seen"] = "detail::Image::tool_columns<Scalar>";
    for (json& argument : function["arguments"])
      argument["as"] = argument["type"] == "JointVector" ? "joints" : "tool_vector";
  }
  for (json& centre : values["wrist"])
    for (std::size_t i = 0; i < 3; ++i)
      if (json& entry = centre[std::string(1, "xyz"[i])]; image.tool.at(i) < 0)
        entry = "-(" + entry.get<std::string>() + ")";
  return values;
}

/// The functions, certified; their counts go to the output.
struct Jacobians {
  model::Robot robot;
  emit::SingularityMeasures measures;
  std::vector<emit::JacobianFunction> functions;
};

Jacobians jacobians_of(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::whatever_notation(described);
  verify::certify_same_pose(described, arm);
  // The header names what vanishes in the description's own angles.
  const canonical::Arm own = canonical::for_kinematics(described);
  auto [measures, measures_function] = singularity_measures_function(own.robot, output);
  Jacobians found{own.robot, measures, {plain_jacobian_function(arm.robot)}};
  for (auto& function : further_jacobian_functions(arm.robot)) found.functions.push_back(std::move(function));
  for (emit::JacobianFunction& function : found.functions)
    function.optimised = optimise::in_terms_of_description(std::move(function.optimised), arm);
  measures_function.optimised =
      optimise::in_terms_of_description(std::move(measures_function.optimised), own);
  found.functions.push_back(std::move(measures_function));
  for (const emit::JacobianFunction& function : found.functions) {
    output.counts[function.name] = to_json(function.optimised);
    output.counts[function.name].erase("forms");  // ways by way of frames: of no interest but to the search
  }
  output.counts["jacobian"]["forms"] = methods(own.robot);
  return found;
}

}  // namespace

void generate_jacobian(const model::Robot& described, RobotOutput& output) {
  const auto [robot, measures, functions] = jacobians_of(described, output);
  const std::vector<dag::Angle> angles = emit::angles_of(functions);
  const emit::ast::Leaves leaves = emit::robot_leaves(robot, angles);
  json values{{"name", robot.name}, {"scalars", emit::scalars()}};
  values["angles"] = emit::angle_values(angles, leaves);
  values["all_angle_count"] = angles.size();
  values["all_sines_cosines"] = emit::sines_cosines_code(angles, leaves, "detail::NoAngles");
  values["functions"] = json::array();
  values["measure_count"] = measures.names.size();
  values["measures"] = measure_values(measures);
  values["wrist"] = wrist_values(robot);
  for (const emit::JacobianFunction& function : functions)
    values["functions"].push_back(emit::to_values(function, robot, angles));
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + "jacobian.h", emit::render("cpp/jacobian.h", values)});
  output.files.push_back(
      {headers + "jacobian_definitions.h", emit::render("cpp/jacobian_definitions.h", values)});
  output.files.push_back(
      {"source/" + robot.name + "/jacobian.cpp", emit::render("cpp/jacobian.cpp", values)});
  for (const model::Image& image : output.images)
    add_image(described, image, "jacobian", true, as_seen(image, values), output);
}

bool has_wrist_centre(const model::Robot& described) {
  return derive::wrist_centre(canonical::for_kinematics(described).robot).has_value();
}

void generate_jacobian_c(const model::Robot& described, RobotOutput& output) {
  const Jacobians found = jacobians_of(described, output);
  add_c_part(output, emit::c::names(found.robot, "singularity", "Values of singularity_measures.",
                                    found.measures.names));
  add_c_part(output, emit::c::jacobian(found.robot, found.functions));
  add_c_files(output, "velocity",
              emit::c::velocity(found.robot, wrist_centre_code(found.robot, emit::c::printer())));
}

}  // namespace qvgen::pipeline
