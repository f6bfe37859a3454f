// SPDX-License-Identifier: MIT
#include "pipeline/products/dynamics.h"

#include <algorithm>

#include <fmt/format.h>

#include "emit/c/parts.h"
#include "emit/cpp/dynamics_code.h"
#include "model/coordinates.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "model/mechanism.h"
#include "optimise/dynamics_derivatives.h"
#include "pipeline/c_files.h"
#include "pipeline/products/dynamics_functions.h"
#include "pipeline/products/model_header.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// Not to be tried again: the choices of the function of that name.
optimise::DynamicsEffort with_choices_of(const std::vector<optimise::Optimised>& functions,
                                         const std::string& name) {
  optimise::DynamicsEffort effort;
  for (const optimise::Optimised& function : functions)
    if (function.name == name) effort.choices = function.choices;
  return effort;
}

/// Adds a function; where there is none the reason goes to what is missing.
void add_to(std::vector<optimise::Optimised>& functions, const optimise::DynamicsModel& model,
            const optimise::DynamicsQuantity& quantity, const optimise::DynamicsEffort& effort,
            RobotOutput& output) {
  try {
    functions.push_back(generate_dynamics(model, quantity, effort));
    measure(model.arm.robot, functions.back());
  } catch (const derive::dynamics::MasslessLink& reason) {
    output.missing.push_back({quantity.name, Missing::Kind::not_derived, reason.what()});
  }
}

std::vector<optimise::Optimised> all_functions(const optimise::DynamicsModel& model, RobotOutput& output) {
  std::vector<optimise::Optimised> functions;
  for (const auto* quantities :
       {&optimise::dynamics_quantities(), &optimise::floating_base_quantities(model.described)})
    for (const optimise::DynamicsQuantity& quantity : *quantities)
      add_to(functions, model, quantity, with_choices_of(functions, quantity.choices_of), output);
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

bool has_friction(const model::Robot& robot) {
  const auto has = [](const auto& moving) { return !moving.drive.coulomb_friction.is_literal_zero(); };
  return std::any_of(robot.joints.begin(), robot.joints.end(), has) ||
         std::any_of(robot.motors.begin(), robot.motors.end(), has);
}

bool has_defaults(const model::Robot& robot) {
  for (const model::Parameter& parameter : robot.inertia_parameters)
    if (parameter.default_value) return true;
  return false;
}

/// True if there is one tool that a wrench may act on; else that is what is missing.
bool has_tool(const model::Robot& robot, const std::string& function, RobotOutput& output) {
  if (!model::branches(robot)) return true;
  output.missing.push_back(
      {function, Missing::Kind::not_described,
       "the joints branch: subtract the transposed Jacobians of the tips times their wrenches, limbs.h"});
  return false;
}

/// With the choices that were best for the functions that they overload.
std::vector<optimise::Optimised> loaded_functions(const optimise::DynamicsModel& model,
                                                  const std::vector<optimise::Optimised>& functions,
                                                  RobotOutput& output) {
  std::vector<optimise::Optimised> result;
  for (const auto& [base, quantity] : optimise::loaded_quantities())
    if (!emit::dynamics_interface(quantity.name).wrench || has_tool(model.described, quantity.name, output))
      add_to(result, model, quantity, with_choices_of(functions, base), output);
  return result;
}

void add_regressor(const optimise::DynamicsModel& model, RobotOutput& output) {
  const model::Robot& robot = model.arm.robot;
  const derive::dynamics::Regressor regressor = derive::dynamics::regressor(robot);
  const optimise::Optimised function = optimise::regressor_function(model, regressor);
  add_function(robot, function, "regressor", "RegressorAngles",
               emit::angles_of(std::vector{in_terms_of_leaders(robot, function)}),
               emit::base_parameter_values(robot, regressor), output);
}

/// Which joints carry one another, for the equations of the mass matrix: of each joint the one before it on
/// its branch. Joints that follow others tie branches together; then all are on one.
json parents_of(const model::Robot& robot) {
  json list = json::array();
  const int base = static_cast<int>(model::base_motions(robot));
  const int count = static_cast<int>(model::coordinate_count(robot));
  for (int i = 0; i < count; ++i) {
    const bool on_one_branch = i < base || model::has_followers(robot);
    // base_link is -1 as a number.
    const int parent =
        on_one_branch ? i - 1
                      : base + static_cast<int>(model::parent_of(robot, static_cast<std::size_t>(i - base)));
    list.push_back({{"parent", parent}, {"last", i + 1 == count}});
  }
  return list;
}

/// The entries of the upper triangle that are not zero.
json nonzeros_of(const optimise::Optimised& mass_matrix, std::size_t size) {
  json list = json::array();
  std::size_t output = 0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i; k < size; ++k)
      if (!mass_matrix.function.graph.is_zero(mass_matrix.function.outputs[output++].value))
        list.push_back({{"row", i}, {"column", k}, {"last", false}});
  if (!list.empty()) list.back()["last"] = true;
  return list;
}

/// The structure of the mass matrix of joints that branch; nothing for a chain, whose matrix is full.
json branches_of(const model::Robot& robot, const std::vector<optimise::Optimised>& functions) {
  const auto mass = std::find_if(functions.begin(), functions.end(),
                                 [](const auto& function) { return function.name == "mass_matrix"; });
  if ((!model::branches(robot) && !robot.floating_base) || mass == functions.end()) return false;
  const json nonzeros = nonzeros_of(*mass, model::coordinate_count(robot));
  return {{"parents", parents_of(robot)},
          {"size", robot.floating_base ? "velocity_size" : "dof"},
          {"nonzeros", nonzeros},
          {"nonzero_count", nonzeros.size()}};
}

/// A base that floats takes gravity in any direction in each function, and wrenches by contacts.h. `how` says
/// how that is asked for.
bool has_loads(const model::Robot& robot, const std::string& how, RobotOutput& output) {
  if (!robot.floating_base) return true;
  output.missing.push_back({"dynamics_loads", Missing::Kind::not_described, "the base floats: " + how});
  return false;
}

bool has_dynamics(const model::Robot& described, RobotOutput& output) {
  if (optimise::has_inertia(described)) return true;
  output.missing.push_back(
      {"dynamics", Missing::Kind::not_described, "the description gives no mass and no inertia"});
  return false;
}

}  // namespace

void generate_dynamics_product(const model::Robot& described, RobotOutput& output) {
  if (!has_dynamics(described, output)) return;
  const optimise::DynamicsModel model = optimise::dynamics_model(described);
  const model::Robot& robot = model.arm.robot;
  const std::vector<optimise::Optimised> functions = all_functions(model, output);
  const std::vector<optimise::Optimised> written = in_terms_of_leaders(robot, functions);
  const json inertia{
      {"parameters", parameters_of(robot)},  {"parameter_count", robot.inertia_parameters.size()},
      {"has_friction", has_friction(robot)}, {"has_parameters", !robot.inertia_parameters.empty()},
      {"has_defaults", has_defaults(robot)}, {"branches", branches_of(robot, written)}};
  add_functions(robot, written, "dynamics", "DynamicsAngles", inertia, output);
  const auto derivatives = [&](RobotOutput& made) {
    add_function(robot, inverse_dynamics_derivatives(model, functions.front()), "dynamics_derivatives",
                 "DynamicsAngles", emit::angles_of(written), json::object(), made);
  };
  const auto loads = [&](RobotOutput& made) {
    add_functions(robot, in_terms_of_leaders(robot, loaded_functions(model, functions, made)),
                  "dynamics_loads", "LoadAngles", json::object(), made);
  };
  const auto regressor = [&](RobotOutput& made) { add_regressor(model, made); };
  std::vector<PartOfOutput> parts{
      {"dynamics_derivatives", derivatives}, {"dynamics_loads", loads}, {"regressor", regressor}};
  if (!has_loads(described, "functions of dynamics.h take gravity in any direction", output))
    parts.erase(parts.begin() + 1);
  attempt_all(without_requested(parts, described.on_request, output), output);
}

void generate_dynamics_c(const model::Robot& described, RobotOutput& output) {
  if (!has_dynamics(described, output)) return;
  const optimise::DynamicsModel model = optimise::dynamics_model(described);
  const model::Robot& robot = model.arm.robot;
  const auto add = [&robot](const std::vector<optimise::Optimised>& derived, RobotOutput& made) {
    const std::vector<optimise::Optimised> functions = in_terms_of_leaders(robot, derived);
    add_c_part(made, emit::c::dynamics(robot, functions));
    for (const optimise::Optimised& function : functions)
      made.counts[function.name] = entry_of(robot, function);
  };
  const std::vector<optimise::Optimised> functions = all_functions(model, output);
  add_c_part(output, emit::c::inertia(robot, constants_of(robot, robot.inertia_parameters)));
  add(functions, output);
  const auto derivatives = [&](RobotOutput& made) {
    optimise::Optimised function = inverse_dynamics_derivatives(model, functions.front());
    measure(robot, function);
    add({function}, made);
  };
  const auto loads = [&](RobotOutput& made) { add(loaded_functions(model, functions, made), made); };
  const auto with_regressor = [&](RobotOutput& made) {
    const derive::dynamics::Regressor regressor = derive::dynamics::regressor(robot);
    optimise::Optimised function = optimise::regressor_function(model, regressor);
    measure(robot, function);
    function = in_terms_of_leaders(robot, std::move(function));
    add_c_part(made, emit::c::regressor(robot, regressor, function));
    made.counts[function.name] = entry_of(robot, function);
  };
  std::vector<PartOfOutput> parts{
      {"dynamics_derivatives", derivatives}, {"dynamics_loads", loads}, {"regressor", with_regressor}};
  if (!has_loads(described, "functions under gravity have another form, ..._with_gravity_vector", output))
    parts.erase(parts.begin() + 1);
  attempt_all(without_requested(parts, described.on_request, output), output);
}

}  // namespace qvgen::pipeline
