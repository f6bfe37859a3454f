// SPDX-License-Identifier: MIT
#include "pipeline/products/dynamics_functions.h"

#include "emit/cpp/angles.h"
#include "emit/cpp/dynamics_code.h"
#include "emit/cpp/scalars.h"
#include "emit/leaves.h"
#include "emit/math/dynamics_choices.h"
#include "emit/render.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "optimise/dynamics.h"
#include "optimise/optimised_json.h"
#include "verify/accuracy.h"

namespace qvgen::pipeline {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr int accuracy_points = 50;

}  // namespace

ordered_json entry_of(const model::Robot& robot, const optimise::Optimised& function) {
  return to_json(function, function.choices ? emit::choices_text(robot, *function.choices) : "");
}

void measure(const model::Robot& robot, optimise::Optimised& function) {
  verify::OutputGroup all;
  for (const dag::Output& output : function.function.outputs) all.push_back(output.name);
  if (const auto with_numbers = with_default_values(robot, function))
    function.largest_error = verify::largest_error_in_ulps(*with_numbers, {all}, accuracy_points);
}

optimise::Optimised in_terms_of_leaders(const model::Robot& robot, optimise::Optimised function) {
  if (!model::has_followers(robot)) return function;
  function.function = optimise::in_terms_of_leaders(function.function, robot);
  function.counts = dag::count(function.function, derive::dynamics::is_constant_symbol);
  return function;
}

std::vector<optimise::Optimised> in_terms_of_leaders(const model::Robot& robot,
                                                     std::vector<optimise::Optimised> functions) {
  for (optimise::Optimised& function : functions) function = in_terms_of_leaders(robot, std::move(function));
  return functions;
}

namespace {

/// Adds one header with its definitions and source, for the functions' values in `values` and their
/// instances.
void add_files(const model::Robot& robot, const std::string& part, const json& values, RobotOutput& output) {
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + part + ".h", emit::render("cpp/" + part + ".h", values)});
  output.files.push_back(
      {headers + part + "_definitions.h", emit::render("cpp/" + part + "_definitions.h", values)});
  output.files.push_back(
      {"source/" + robot.name + "/" + part + ".cpp", emit::render("cpp/" + part + ".cpp", values)});
}

json angles_and_name(const model::Robot& robot, const std::vector<dag::Angle>& angles,
                     const std::string& angles_type) {
  const emit::ast::Leaves leaves = emit::robot_leaves(robot, angles);
  return {{"name", robot.name},
          {"base_floats", robot.floating_base.has_value()},
          {"vector_type", robot.floating_base ? "Velocity" : "JointVector"},
          {"velocity_size", robot.floating_base ? "velocity_size" : "dof"},
          {"angles", emit::angle_values(angles, leaves)},
          {"angle_count", angles.size()},
          {"angles_type", angles_type},
          {"sines_cosines", emit::sines_cosines_code(angles, leaves, angles_type)}};
}

}  // namespace

void add_functions(const model::Robot& robot, const std::vector<optimise::Optimised>& functions,
                   const std::string& part, const std::string& angles_type, json values,
                   RobotOutput& output) {
  const auto angles = emit::angles_of(functions);
  const auto values_for = [&](const std::string& scalar) {
    json list = json::array();
    for (const optimise::Optimised& function : functions)
      list.push_back(
          emit::dynamics_values(robot, function, emit::dynamics_interface(function.name), angles, scalar));
    return list;
  };
  values.update(angles_and_name(robot, angles, angles_type));
  values["functions"] = values_for("Scalar");
  values["instances"] = emit::scalars();
  for (json& instance : values["instances"]) instance["functions"] = values_for(instance["scalar"]);
  add_files(robot, part, values, output);
  for (const optimise::Optimised& function : functions)
    output.counts[function.name] = entry_of(robot, function);
}

void add_function(const model::Robot& robot, optimise::Optimised function, const std::string& part,
                  const std::string& angles_type, const std::vector<dag::Angle>& angles, json values,
                  RobotOutput& output) {
  measure(robot, function);
  function = in_terms_of_leaders(robot, std::move(function));
  const auto values_for = [&](const std::string& scalar) {
    return emit::dynamics_values(robot, function, emit::dynamics_interface(function.name), angles, scalar);
  };
  values.update(values_for("Scalar"));
  values.update(angles_and_name(robot, angles, angles_type));
  values["instances"] = emit::scalars();
  for (json& instance : values["instances"]) instance.update(values_for(instance["scalar"]));
  add_files(robot, part, values, output);
  output.counts[function.name] = entry_of(robot, function);
}

}  // namespace qvgen::pipeline
