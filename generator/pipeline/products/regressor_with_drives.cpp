// SPDX-License-Identifier: MIT
#include "pipeline/products/regressor_with_drives.h"

#include "emit/c/parts.h"
#include "emit/cpp/dynamics_code.h"
#include "optimise/dynamics_derivatives.h"
#include "pipeline/c_files.h"
#include "pipeline/products/dynamics_functions.h"

namespace qvgen::pipeline {
namespace {

bool has_dynamics(const model::Robot& described, RobotOutput& output) {
  if (optimise::has_inertia(described)) return true;
  output.missing.push_back({"regressor_with_drives", Missing::Kind::not_described,
                            "the description gives no mass and no inertia"});
  return false;
}

/// The function, certified, with its parameters and the arm that it is of.
struct Found {
  model::Robot robot;
  derive::dynamics::DriveRegressor regressor;
  optimise::Optimised function;
};

Found find(const model::Robot& described) {
  const optimise::DynamicsModel model = optimise::dynamics_model(described);
  derive::dynamics::DriveRegressor regressor =
      derive::dynamics::regressor_with_drives(model.arm.robot, model.arm.reversed);
  optimise::Optimised function = drive_regressor_function(model, regressor.regressor);
  return {model.arm.robot, std::move(regressor), std::move(function)};
}

}  // namespace

void generate_regressor_with_drives(const model::Robot& described, RobotOutput& output) {
  if (!has_dynamics(described, output)) return;
  const auto [robot, regressor, function] = find(described);
  add_function(robot, function, "regressor_with_drives", "DriveRegressorAngles",
               emit::angles_of(std::vector{in_terms_of_leaders(robot, function)}),
               emit::identifiable_parameter_values(robot, regressor), output);
}

void generate_regressor_with_drives_c(const model::Robot& described, RobotOutput& output) {
  if (!has_dynamics(described, output)) return;
  auto [robot, regressor, function] = find(described);
  measure(robot, function);
  function = in_terms_of_leaders(robot, std::move(function));
  add_c_part(output, emit::c::regressor_with_drives(robot, regressor, function));
  output.counts[function.name] = entry_of(robot, function);
}

}  // namespace qvgen::pipeline
