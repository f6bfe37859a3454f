// SPDX-License-Identifier: MIT
#include "pipeline/products/jacobian.h"

#include "dag/import.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/wrist.h"
#include "emit/c/parts.h"
#include "emit/cpp/code.h"
#include "emit/cpp/jacobian_function.h"
#include "emit/cpp/symbol_table.h"
#include "emit/math/singularities.h"
#include "emit/render.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "optimise/optimised_json.h"
#include "passes/pass.h"
#include "pipeline/c_files.h"
#include "verify/certificate.h"
#include "verify/counts_json.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr int accuracy_points = 16;

optimise::OptimiseOptions options() {
  optimise::OptimiseOptions result;
  result.also_fewest = false;  // all in full angles: the cheapest has the fewest operations too
  result.simplify_forms = false;
  result.certificate_points = 3;
  result.search.iterations = 100'000;
  return result;
}

/// Linear and angular part of each column apart: they have different units.
std::vector<verify::OutputGroup> jacobian_groups(std::size_t dof) {
  std::vector<verify::OutputGroup> groups;
  for (std::size_t j = 0; j < dof; ++j)
    for (std::size_t part = 0; part < 6; part += 3)
      groups.push_back({derive::jacobian_entry(part, j), derive::jacobian_entry(part + 1, j),
                        derive::jacobian_entry(part + 2, j)});
  return groups;
}

std::vector<verify::OutputGroup> twist_groups() { return {{"v1", "v2", "v3"}, {"w1", "w2", "w3"}}; }

std::string place(const std::string& what, std::size_t row, std::size_t column) {
  return what + "(" + std::to_string(row) + ", " + std::to_string(column) + ")";
}

std::vector<std::string> matrix_targets(const std::string& what, std::size_t columns) {
  std::vector<std::string> targets;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = 0; column < columns; ++column) targets.push_back(place(what, row, column));
  return targets;
}

std::vector<std::string> transform_targets() {
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < 9; ++i) targets.push_back(place("result.transform", i / 3, i % 3));
  for (std::size_t i = 0; i < 3; ++i) targets.push_back(place("result.transform", i, 3));
  return targets;
}

optimise::Optimised with_accuracy(const derive::Quantity& quantity,
                                  const std::vector<verify::OutputGroup>& groups) {
  optimise::Optimised result = optimise::optimise(quantity, options());
  result.largest_error = verify::largest_error_in_ulps(result.function, groups, accuracy_points);
  return result;
}

/// A function whose result is a 6 x n matrix or a twist.
emit::JacobianFunction matrix_function(const derive::Quantity& quantity, std::size_t dof,
                                       const std::vector<emit::JacobianFunction::Argument>& arguments,
                                       const std::vector<std::string>& text) {
  return {quantity.name,
          "Jacobian",
          arguments,
          text,
          "",
          matrix_targets("result", dof),
          with_accuracy(quantity, jacobian_groups(dof))};
}

emit::JacobianFunction twist_function(const derive::Quantity& quantity,
                                      const std::vector<std::string>& text) {
  return {quantity.name,
          "Twist",
          {{"JointVector", "qd"}},
          text,
          "",
          matrix_targets("result", 1),
          with_accuracy(quantity, twist_groups())};
}

emit::JacobianFunction transform_function(const model::Robot& robot) {
  const derive::Quantity quantity = derive::transform_and_jacobian(robot);
  const std::size_t dof = model::driven_count(robot);
  std::vector<verify::OutputGroup> groups = jacobian_groups(dof);
  groups.push_back({"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"});
  groups.push_back({"px", "py", "pz"});
  std::vector<std::string> targets = transform_targets();
  for (const std::string& target : matrix_targets("result.jacobian", dof)) targets.push_back(target);
  return {quantity.name,
          "TransformAndJacobian",
          {},
          {"Pose of the tool in the world frame as a homogeneous transformation, and `jacobian`, with all "
           "that they share",
           "computed once."},
          "result.transform.makeAffine();",
          targets,
          with_accuracy(quantity, groups)};
}

/// One value per factor; each is a group of its own.
emit::JacobianFunction measures_function(const emit::SingularityMeasures& measures) {
  const std::size_t count = measures.names.size();
  emit::JacobianFunction function{measures.quantity.name, "SingularityMeasures", {}, {}, "", {}, {}};
  function.text = {
      "One value for each factor of the determinant of the Jacobian (named in `singularity_names`): the arm "
      "is singular",
      "exactly where one of them is zero. None for arms with more than six joints, see "
      "qvgen/manipulability.h."};
  if (count == 0) return function;
  std::vector<verify::OutputGroup> groups;
  for (std::size_t i = 0; i < count; ++i) {
    function.targets.push_back(place("result", i, 0));
    groups.push_back({measures.quantity.definition.outputs()[i].name});
  }
  function.optimised = with_accuracy(measures.quantity, groups);
  return function;
}

/// The measures and their function; none, and the reason in the output, if they cannot be had.
std::pair<emit::SingularityMeasures, emit::JacobianFunction> measures_of(const model::Robot& robot,
                                                                         RobotOutput& output) {
  emit::SingularityMeasures measures;
  measures.quantity.name = "singularity_measures";
  emit::JacobianFunction function = measures_function(measures);
  attempt(measures.quantity.name, output, [&](RobotOutput&) {
    emit::SingularityMeasures found = emit::singularity_measures(robot);
    function = measures_function(found);
    measures = std::move(found);
  });
  if (!output.missing.empty()) function.text.push_back("None for this arm: " + output.missing.back().reason);
  return {measures, function};
}

std::vector<emit::JacobianFunction> functions_of(const model::Robot& robot,
                                                 const emit::JacobianFunction& measures) {
  const std::size_t dof = model::driven_count(robot);
  return {
      matrix_function(derive::jacobian(robot), dof, {},
                      {"Jacobian of the tool point in the base frame: the twist of the tool is `jacobian(q) "
                       "* qd` (m/s, rad/s); linear rows",
                       "first (Jacobian lecture, section 5.4: iteration, cross products and differentiation "
                       "all give it)."}),
      transform_function(robot),
      matrix_function(
          derive::tool_jacobian(robot), dof, {},
          {"The Jacobian of the tool point in the tool frame: both halves of each column turned into it."}),
      matrix_function(derive::jacobian_at(robot), dof, {{"Vector3", "point"}},
                      {"The Jacobian in the base frame at a point that moves with the tool, given in the "
                       "tool frame (m)."}),
      twist_function(derive::velocity(robot), {"Twist of the tool in the base frame at the joint rates qd "
                                               "(rad/s, m/s): `jacobian(q) * qd`, linear part first."}),
      matrix_function(derive::jacobian_rate(robot), dof, {{"JointVector", "qd"}},
                      {"Derivative of `jacobian` by time at the joint rates qd."}),
      twist_function(derive::acceleration_bias(robot),
                     {"The tool's acceleration (m/s², rad/s²) at constant joint rates qd: `jacobian_dot(q, "
                      "qd) * qd`; with joint accelerations",
                      "it is `jacobian(q) * qdd` plus this."}),
      measures,
  };
}

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

/// The wrist centre in the tool frame, if there is one: a list of one or none.
json wrist_values(const model::Robot& robot) {
  const auto centre = derive::wrist_centre(robot);
  if (!centre) return json::array();
  symbolic::Program program;
  program.output("x", centre->x);
  program.output("y", centre->y);
  program.output("z", centre->z);
  json values;
  for (const auto& value : emit::straight_code(dag::import(program), emit::symbol_table(robot, {})).outputs)
    values[value.name] = value.expression;
  return json::array({values});
}

/// The functions, certified; their counts go to the output.
struct Jacobians {
  model::Robot robot;
  emit::SingularityMeasures measures;
  std::vector<emit::JacobianFunction> functions;
};

Jacobians jacobians_of(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto [measures, measures_function] = measures_of(arm.robot, output);
  Jacobians found{arm.robot, measures, functions_of(arm.robot, measures_function)};
  for (emit::JacobianFunction& function : found.functions) {
    function.optimised = optimise::in_terms_of_description(std::move(function.optimised), arm);
    output.counts[function.name] = to_json(function.optimised);
    output.counts[function.name].erase("forms");  // ways by way of frames: of no interest but to the search
  }
  output.counts["jacobian"]["forms"] = methods(arm.robot);
  return found;
}

}  // namespace

void generate_jacobian(const model::Robot& described, RobotOutput& output) {
  const auto [robot, measures, functions] = jacobians_of(described, output);
  const std::vector<dag::Angle> angles = emit::angles_of(functions);
  const emit::SymbolTable names = emit::symbol_table(robot, angles);
  json values{{"name", robot.name}, {"scalars", {{{"scalar", "double"}}, {{"scalar", "float"}}}}};
  values["angles"] = emit::angle_values(angles, names);
  values["all_angle_count"] = angles.size();
  values["all_sines_cosines"] = sines_cosines_code(angles, names, "detail::NoAngles");
  values["functions"] = json::array();
  values["measure_count"] = measures.names.size();
  values["measures"] = measure_values(measures);
  values["wrist"] = wrist_values(robot);
  for (const emit::JacobianFunction& function : functions)
    values["functions"].push_back(emit::to_values(function, robot, angles));
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + "jacobian.h", emit::render("jacobian.h", values)});
  output.files.push_back(
      {headers + "jacobian_definitions.h", emit::render("jacobian_definitions.h", values)});
  output.files.push_back({"source/" + robot.name + "/jacobian.cpp", emit::render("jacobian.cpp", values)});
}

bool has_wrist_centre(const model::Robot& described) {
  return derive::wrist_centre(canonical::for_kinematics(described).robot).has_value();
}

void generate_jacobian_c(const model::Robot& described, RobotOutput& output) {
  const Jacobians found = jacobians_of(described, output);
  add_c_part(output, emit::c::jacobian(found.robot, found.functions));
}

}  // namespace qvgen::pipeline
