// SPDX-License-Identifier: MIT
#include "derive/dynamics/drive_regressor.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "dag/evaluate.h"
#include "derive/dynamics/column_relations.h"
#include "derive/dynamics/drive_parameters.h"
#include "model/coordinates.h"
#include "model/followers.h"

namespace qvgen::derive::dynamics {
namespace {

/// A column of Y with the parameter that it is multiplied by.
struct DriveColumn {
  std::string name;
  std::vector<dag::Edge> entries;  ///< of the function's graph, one a row
  dag::Edge parameter;             ///< of the parameters' graph
};

const std::map<DriveParameter, std::string>& short_names() {
  static const std::map<DriveParameter, std::string> names{{DriveParameter::rotor_inertia, "Ia"},
                                                           {DriveParameter::viscous_friction, "fv"},
                                                           {DriveParameter::coulomb_friction, "fc"},
                                                           {DriveParameter::offset, "off"}};
  return names;
}

std::vector<DriveColumn> columns_of_links(const Regressor& links, std::size_t rows) {
  std::vector<DriveColumn> columns;
  for (std::size_t k = 0; k < links.names.size(); ++k) {
    columns.push_back({links.names[k], {}, links.base_parameters.outputs[k].value});
    for (std::size_t i = 0; i < rows; ++i)
      columns.back().entries.push_back(links.formulation.function.outputs[k * rows + i].value);
  }
  return columns;
}

/// Returns the factor of a drive of the chain, in terms of the joint that moves it. With the ratio r it turns
/// r times as fast, and its force counts r times.
dag::Edge factor_of(DriveParameter kind, const cln::cl_RA& ratio, const std::string& driven, bool reversed,
                    dag::Graph& graph) {
  const auto times = [&](const cln::cl_RA& factor, dag::Edge value) {
    return graph.product({graph.constant(exact::Number(factor)), value});
  };
  switch (kind) {
    case DriveParameter::rotor_inertia:
      return times(ratio * ratio, graph.symbol(acceleration_of(driven)));
    case DriveParameter::viscous_friction:
      return times(ratio * ratio, graph.symbol(velocity_of(driven)));
    case DriveParameter::coulomb_friction:
      return times(cln::abs(ratio), graph.symbol(direction_of(driven)));
    case DriveParameter::offset:
      break;
  }
  return graph.constant(exact::Number(reversed ? -ratio : ratio));
}

/// The columns of one kind of drive parameter, a chain's joint each.
std::vector<DriveColumn> columns_of_drives(const model::Robot& robot, const std::vector<bool>& reversed,
                                           DriveParameter kind, Regressor& regressor) {
  dag::Graph& graph = regressor.formulation.function.graph;
  const std::vector<std::vector<model::Share>> shares = model::shares(robot);
  const std::vector<std::string> coordinates = model::coordinates(robot);
  std::vector<DriveColumn> columns;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto& [driven, ratio] = shares[i].front();
    const std::size_t row = model::base_motions(robot) + driven;
    const bool opposite = !reversed.empty() && reversed[i];
    DriveColumn column{short_names().at(kind) + std::to_string(i + 1),
                       std::vector<dag::Edge>(coordinates.size(), graph.constant(0)),
                       regressor.base_parameters.graph.symbol(drive_parameter(i, kind))};
    column.entries[row] = factor_of(kind, ratio, coordinates[row], opposite, graph);
    columns.push_back(std::move(column));
  }
  return columns;
}

/// The order in which columns are kept: with offsets first no coefficient divides by gravity.
std::vector<std::size_t> order_of(std::size_t links, std::size_t drives_of_kind) {
  std::vector<std::size_t> order;
  const std::size_t offsets = links + 3 * drives_of_kind;
  for (std::size_t i = 0; i < drives_of_kind; ++i) order.push_back(offsets + i);
  for (std::size_t i = 0; i < offsets; ++i) order.push_back(i);
  return order;
}

dag::Function function_of(const dag::Graph& graph, const std::vector<DriveColumn>& columns) {
  dag::Function function{graph, {}};
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t i = 0; i < columns[k].entries.size(); ++i)
      function.outputs.push_back(
          {"y" + std::to_string(i + 1) + "_" + std::to_string(k + 1), columns[k].entries[i]});
  return function;
}

using Relations = std::vector<std::optional<Relation>>;

/// Which columns depend on others. The wrench on a base that floats tells all that the links' columns do: a
/// combination of them without that wrench is zero (Ayusawa, Venture and Nakamura 2014). Drives are not in
/// that wrench, so that their columns depend on one another alone, by joints that follow.
Relations relations_of(const model::Robot& robot, const Formulation& links, std::size_t count_of_links,
                       const std::vector<DriveColumn>& columns) {
  const std::size_t left_out = robot.floating_base ? count_of_links : 0;
  const std::vector<DriveColumn> compared(columns.begin() + static_cast<std::ptrdiff_t>(left_out),
                                          columns.end());
  const Relations found = relations_of_columns(
      robot, {function_of(links.function.graph, compared), links.constants}, model::coordinate_count(robot),
      order_of(count_of_links - left_out, robot.joints.size()));
  Relations result(left_out);
  for (const std::optional<Relation>& relation : found) {
    result.emplace_back();
    if (!relation) continue;
    result.back().emplace();
    for (const auto& [index, coefficient] : *relation) result.back()->emplace(index + left_out, coefficient);
  }
  return result;
}

dag::Edge value_of(const Coefficient& coefficient, dag::Graph& graph) {
  const dag::Edge factor = graph.constant(exact::Number(coefficient.factor));
  return coefficient.of_gravity ? graph.product({factor, graph.symbol(gravity_symbol)}) : factor;
}

std::string names_of(const Relation& relation, const std::vector<DriveColumn>& all) {
  std::string names;
  for (const auto& entry : relation) names += (names.empty() ? "" : ", ") + all[entry.first].name;
  return names;
}

/// Adds the parameter of a column that depends on others to theirs.
void join(const DriveColumn& column, const Relation& relation, std::vector<DriveColumn>& all,
          dag::Graph& parameters) {
  for (const auto& [index, coefficient] : relation) {
    DriveColumn& other = all[index];
    const dag::Edge part = parameters.product({value_of(*coefficient, parameters), column.parameter});
    other.parameter = parameters.sum({other.parameter, part});
  }
}

/// Takes out the columns that others make up by known factors; says so of these and of those that stay.
std::vector<DriveColumn> reduced(std::vector<DriveColumn> columns, const Relations& relations,
                                 DriveRegressor& result) {
  const auto leaves = [&](std::size_t k) { return relations[k] && is_known(*relations[k]); };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (!leaves(k)) continue;
    join(columns[k], *relations[k], columns, result.regressor.base_parameters.graph);
    result.left_out.push_back(columns[k].name + " has no column of its own: it is part of " +
                              names_of(*relations[k], columns));
  }
  std::vector<DriveColumn> kept;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (leaves(k)) continue;
    if (relations[k]) {
      result.dependent.push_back(kept.size());
      result.dependences.push_back(columns[k].name + " depends on others by lengths or angles: on " +
                                   names_of(*relations[k], columns));
    }
    kept.push_back(columns[k]);
  }
  return kept;
}

}  // namespace

DriveRegressor regressor_with_drives(const model::Robot& robot, const std::vector<bool>& reversed) {
  if (!robot.motors.empty())
    throw std::domain_error("joints follow motors that are no joints, whose drives have no columns");
  DriveRegressor result{regressor(robot), {}, {}, {}};
  Regressor& regressor = result.regressor;
  std::vector<DriveColumn> columns = columns_of_links(regressor, model::coordinate_count(robot));
  const std::size_t links = columns.size();
  for (const DriveParameter kind : drive_parameters)
    for (DriveColumn& column : columns_of_drives(robot, reversed, kind, regressor))
      columns.push_back(std::move(column));

  const Relations relations = relations_of(robot, regressor.formulation, links, columns);
  const std::vector<DriveColumn> kept = reduced(std::move(columns), relations, result);
  regressor.formulation.function = function_of(regressor.formulation.function.graph, kept);
  regressor.base_parameters.outputs.clear();
  regressor.names.clear();
  for (const DriveColumn& column : kept) {
    regressor.names.push_back(column.name);
    regressor.base_parameters.outputs.push_back(
        {"b" + std::to_string(regressor.names.size()), column.parameter});
  }
  return result;
}

}  // namespace qvgen::derive::dynamics
