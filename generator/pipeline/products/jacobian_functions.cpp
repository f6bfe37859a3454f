// SPDX-License-Identifier: MIT
#include "pipeline/products/jacobian_functions.h"

#include "derive/jacobian/quantities.h"
#include "model/followers.h"

namespace qvgen::pipeline {
namespace {

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

}  // namespace

MeasuresFunction singularity_measures_function(const model::Robot& robot, RobotOutput& output) {
  MeasuresFunction result;
  result.measures.quantity.name = "singularity_measures";
  result.function = measures_function(result.measures);
  attempt(result.measures.quantity.name, output, [&](RobotOutput&) {
    emit::SingularityMeasures found = emit::singularity_measures(robot);
    result.function = measures_function(found);
    result.measures = std::move(found);
  });
  if (!output.missing.empty())
    result.function.text.push_back("None for this arm: " + output.missing.back().reason);
  return result;
}

emit::JacobianFunction plain_jacobian_function(const model::Robot& robot) {
  return matrix_function(
      derive::jacobian(robot), model::driven_count(robot), {},
      {"Jacobian of the tool point in the base frame: the twist of the tool is `jacobian(q) "
       "* qd` (m/s, rad/s); linear rows",
       "first (Jacobian lecture, section 5.4: iteration, cross products and differentiation "
       "all give it)."});
}

std::vector<emit::JacobianFunction> further_jacobian_functions(const model::Robot& robot) {
  const std::size_t dof = model::driven_count(robot);
  return {
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
  };
}

}  // namespace qvgen::pipeline
