// SPDX-License-Identifier: MIT
#include "application/products/dynamics.h"

#include <cmath>

#include <fmt/format.h>

#include "application/accuracy.h"
#include "application/dynamics_derivatives.h"
#include "application/products/counts_json.h"
#include "application/products/dynamics_code.h"
#include "application/products/leaf_names.h"
#include "emit/render.h"
#include "model/evaluate.h"

namespace qvgen::application {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int accuracy_points = 50;

ordered_json entry_of(const DynamicsFunction& function) {
  ordered_json entry{{"emitted", to_json(function.counts)},
                     {"set_up", to_json(function.constant_counts)},
                     {"certified_points", function.certified_points},
                     {"choices", function.choices}};
  if (function.largest_error > 0) entry["largest_error_ulp"] = std::round(function.largest_error * 100) / 100;
  return entry;
}

void measure(const model::Robot& robot, DynamicsFunction& function) {
  OutputGroup all;
  for (const dag::Output& output : function.function.outputs) all.push_back(output.name);
  if (const auto with_numbers = with_default_values(robot, function))
    function.largest_error = largest_error_in_ulps(*with_numbers, {all}, accuracy_points);
}

/// Not to be tried again: the choices of the function of that name.
DynamicsEffort with_choices_of(const std::vector<DynamicsFunction>& functions, const std::string& name) {
  DynamicsEffort effort;
  for (const DynamicsFunction& function : functions)
    if (function.name == name) effort.choices = function.chosen;
  return effort;
}

std::vector<DynamicsFunction> all_functions(const model::Robot& robot) {
  std::vector<DynamicsFunction> functions;
  for (const DynamicsQuantity& quantity : dynamics_quantities()) {
    functions.push_back(generate_dynamics(robot, quantity, with_choices_of(functions, quantity.choices_of)));
    measure(robot, functions.back());
  }
  return functions;
}

json parameters_of(const model::Robot& robot) {
  json list = json::array();
  for (const model::Parameter& parameter : robot.inertia_parameters) {
    std::string value = "0";
    if (parameter.default_value)
      value = fmt::format(
          "{}", model::to_double(model::evaluate(*parameter.default_value, model::default_bindings(robot))));
    const bool last = &parameter == &robot.inertia_parameters.back();
    list.push_back({{"name", parameter.name}, {"default", value}, {"last", last}});
  }
  return list;
}

bool has_defaults(const model::Robot& robot) {
  for (const model::Parameter& parameter : robot.inertia_parameters)
    if (parameter.default_value) return true;
  return false;
}

/// Adds one header with its definitions and source, for the functions' values in `values` and their
/// instances.
void add_files(const model::Robot& robot, const std::string& part, const json& values, RobotOutput& output) {
  const std::string headers = "include/qvgen/robots/" + robot.name + "/";
  output.files.push_back({headers + part + ".h", emit::render(part + ".h", values)});
  output.files.push_back({headers + part + "_definitions.h", emit::render(part + "_definitions.h", values)});
  output.files.push_back({"source/" + robot.name + "/" + part + ".cpp", emit::render(part + ".cpp", values)});
}

json angles_and_name(const model::Robot& robot, const std::vector<dag::Angle>& angles,
                     const std::string& angles_type) {
  const emit::Names names = leaf_names(robot, angles);
  return {{"name", robot.name},
          {"angles", angle_values(angles, names)},
          {"angle_count", angles.size()},
          {"angles_type", angles_type},
          {"sines_cosines", sines_cosines_code(angles, names, angles_type)}};
}

/// A header of several functions that share sines and cosines.
void add_functions(const model::Robot& robot, const std::vector<DynamicsFunction>& functions,
                   const std::string& part, json values, RobotOutput& output) {
  const auto angles = angles_of(functions);
  const auto values_for = [&](const std::string& scalar) {
    json list = json::array();
    for (const DynamicsFunction& function : functions)
      list.push_back(dynamics_values(robot, function, dynamics_interface(function.name), angles, scalar));
    return list;
  };
  values.update(angles_and_name(robot, angles, part == "dynamics" ? "DynamicsAngles" : "LoadAngles"));
  values["functions"] = values_for("Scalar");
  values["instances"] = json::array();
  for (const char* scalar : {"double", "float"})
    values["instances"].push_back({{"scalar", scalar}, {"functions", values_for(scalar)}});
  add_files(robot, part, values, output);
  for (const DynamicsFunction& function : functions) output.counts[function.name] = entry_of(function);
}

/// A header of a single function.
void add_function(const model::Robot& robot, DynamicsFunction function, const std::string& part,
                  const std::vector<dag::Angle>& angles, json values, RobotOutput& output) {
  measure(robot, function);
  const auto values_for = [&](const std::string& scalar) {
    return dynamics_values(robot, function, dynamics_interface(function.name), angles, scalar);
  };
  values.update(values_for("Scalar"));
  values.update(angles_and_name(robot, angles, part == "regressor" ? "RegressorAngles" : "DynamicsAngles"));
  values["instances"] = json::array();
  for (const char* scalar : {"double", "float"}) {
    json instance = values_for(scalar);
    instance["scalar"] = scalar;
    values["instances"].push_back(instance);
  }
  add_files(robot, part, values, output);
  output.counts[function.name] = entry_of(function);
}

/// With the choices that were best for the functions that they overload.
std::vector<DynamicsFunction> loaded_functions(const model::Robot& robot,
                                               const std::vector<DynamicsFunction>& functions) {
  std::vector<DynamicsFunction> result;
  for (const auto& [base, quantity] : loaded_quantities()) {
    result.push_back(generate_dynamics(robot, quantity, with_choices_of(functions, base)));
    measure(robot, result.back());
  }
  return result;
}

void add_regressor(const model::Robot& robot, RobotOutput& output) {
  const derive::dynamics::Regressor regressor = derive::dynamics::regressor(robot);
  const DynamicsFunction function = regressor_function(robot, regressor);
  add_function(robot, function, "regressor", angles_of(std::vector{function}),
               base_parameter_values(robot, regressor), output);
}

}  // namespace

void generate_dynamics_product(const model::Robot& robot, RobotOutput& output) {
  if (!has_inertia(robot)) return;
  const std::vector<DynamicsFunction> functions = all_functions(robot);
  const json inertia{{"parameters", parameters_of(robot)},
                     {"parameter_count", robot.inertia_parameters.size()},
                     {"has_parameters", !robot.inertia_parameters.empty()},
                     {"has_defaults", has_defaults(robot)}};
  add_functions(robot, functions, "dynamics", inertia, output);
  add_function(robot, inverse_dynamics_derivatives(robot, functions.front()), "dynamics_derivatives",
               angles_of(functions), json::object(), output);
  add_functions(robot, loaded_functions(robot, functions), "dynamics_loads", json::object(), output);
  add_regressor(robot, output);
}

}  // namespace qvgen::application
