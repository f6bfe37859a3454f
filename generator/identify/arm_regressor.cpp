// SPDX-License-Identifier: MIT
#include "identify/arm_regressor.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "canonical/right_angles.h"
#include "derive/dynamics/drive_regressor.h"
#include "derive/dynamics/formulation.h"
#include "model/evaluate.h"
#include "model/followers.h"
#include "optimise/described.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
namespace dynamics = derive::dynamics;

Known defaults_of(const model::Robot& robot, double gravity) {
  Known known{{dynamics::gravity_symbol, gravity}};
  for (const auto& [name, value] : model::default_bindings(robot))
    known.emplace(name, model::to_double(value));
  return known;
}

/// Adds the constants' values. Those of inertias do not occur in the columns: they may be anything.
void add_values(const dag::Function& function, const std::vector<std::string>& inertias, Known& known) {
  Known all = known;
  for (const std::string& symbol : inertias) all[symbol] = 1;
  const std::vector<double> values = values_of(function, all);
  for (std::size_t i = 0; i < values.size(); ++i) known[function.outputs[i].name] = values[i];
}

/// The symbols that change along a log: values, rates, accelerations and directions, each joint by joint.
std::vector<std::string> inputs_of(const model::Robot& robot) {
  std::vector<std::string> inputs;
  const std::vector<std::string> variables = model::variables(robot);
  for (const auto& named : {+[](const std::string& v) { return v; }, dynamics::velocity_of,
                            dynamics::acceleration_of, dynamics::direction_of})
    std::transform(variables.begin(), variables.end(), std::back_inserter(inputs), named);
  return inputs;
}

/// The symbols that the parameters are linear in.
std::vector<std::string> parameter_symbols(const model::Robot& robot) {
  std::vector<std::string> symbols;
  for (std::size_t i = 0; i < 10 * robot.joints.size(); ++i)
    symbols.push_back(dynamics::standard_parameter(i));
  for (std::size_t i = 0; i < dynamics::drive_parameters.size() * dynamics::drive_count(robot); ++i)
    symbols.push_back(dynamics::drive_parameter(i));
  return symbols;
}

/// A linear function's matrix, column by column from unit vectors.
MatrixXd matrix_of(const dag::Function& parameters, const std::vector<std::string>& symbols, Known known) {
  MatrixXd matrix(static_cast<Index>(parameters.outputs.size()), static_cast<Index>(symbols.size()));
  for (const std::string& symbol : symbols) known[symbol] = 0;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    known[symbols[k]] = 1;
    const std::vector<double> column = values_of(parameters, known);
    matrix.col(static_cast<Index>(k)) = Eigen::VectorXd::Map(column.data(), matrix.rows());
    known[symbols[k]] = 0;
  }
  return matrix;
}

/// Drives that the joints are taken not to have are zero: their shares in all parameters vanish.
void remove_drives(ArmRegressor& arm) {
  for (const DriveParameter kind : dynamics::drive_parameters) {
    if (std::find(arm.drives.begin(), arm.drives.end(), kind) != arm.drives.end()) continue;
    for (std::size_t i = 0; i < arm.drive_units(); ++i)
      arm.combination.col(arm.standard() + static_cast<Index>(dynamics::place_of(i, kind))).setZero();
  }
}

/// Drops parameters that nothing is left of, with their columns of Y.
void remove_empty(std::size_t rows, ArmRegressor& result, dag::Function& function) {
  std::vector<dag::Output> outputs;
  std::vector<std::string> names;
  for (Index k = 0; k < result.combination.rows(); ++k) {
    if (result.combination.row(k).isZero(0)) continue;
    result.combination.row(static_cast<Index>(names.size())) = result.combination.row(k);
    names.push_back(result.names[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < rows; ++i)
      outputs.push_back(function.outputs[static_cast<std::size_t>(k) * rows + i]);
  }
  result.combination.conservativeResize(static_cast<Index>(names.size()), Eigen::NoChange);
  result.names = names;
  function.outputs = outputs;
}

std::vector<std::vector<Index>> columns_of(const Tape& tape, std::size_t rows, std::size_t count) {
  std::vector<std::vector<Index>> columns(rows);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < rows; ++i)
      if (!tape.vanishes(k * rows + i)) columns[i].push_back(static_cast<Index>(k));
  return columns;
}

}  // namespace

std::vector<std::string> names_of_motors(const model::Robot& robot) {
  std::vector<std::string> names;
  for (const model::Motor& motor : robot.motors) names.push_back(motor.variable);
  return names;
}

std::vector<DriveParameter> all_drives() {
  return {dynamics::drive_parameters.begin(), dynamics::drive_parameters.end()};
}

ArmRegressor arm_regressor(const model::Robot& described, const std::vector<DriveParameter>& drives,
                           double gravity) {
  const canonical::Arm arm = canonical::whatever_notation_with_links(described).front();
  const dynamics::DriveRegressor found = dynamics::regressor_with_drives(arm.robot, arm.reversed);
  const dynamics::Regressor& regressor = found.regressor;
  const std::size_t rows = model::driven_count(arm.robot), links = arm.robot.joints.size();
  Known known = defaults_of(described, gravity);
  const dag::Function parameters = optimise::with_definitions(regressor.base_parameters, arm.robot);
  const std::vector<std::string> symbols = parameter_symbols(arm.robot);
  const MatrixXd combination = matrix_of(parameters, symbols, known);
  add_values(optimise::with_definitions(regressor.formulation.constants, arm.robot), symbols, known);
  dag::Function function = optimise::in_terms_of_leaders(
      optimise::dynamics_in_terms_of_description(regressor.formulation.function, arm), arm.robot);
  ArmRegressor result{
      rows, links, names_of_motors(arm.robot), regressor.names, drives, combination, {}, Tape({}, {}, {}),
      {}};
  remove_drives(result);
  if (drives.size() == dynamics::drive_parameters.size()) result.left_out = found.left_out;
  remove_empty(rows, result, function);
  result.tape = Tape(function, inputs_of(described), known);
  result.columns = columns_of(result.tape, rows, result.names.size());
  return result;
}

}  // namespace qvgen::identify
