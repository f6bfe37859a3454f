// SPDX-License-Identifier: MIT
#include "derive/dynamics/drive_regressor.h"

#include <algorithm>
#include <map>

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

/// A drive with what moves it: it turns by the shares' sum, and its force counts by each share's ratio.
struct DriveUnit {
  std::string suffix;  ///< of its parameters' names: the joint's number, or '_' and the motor's name
  std::vector<model::Share> shares;
  bool reversed = false;  ///< its offset counts the other way
};

/// Returns the drives in the order of their parameters.
std::vector<DriveUnit> units_of(const model::Robot& robot, const std::vector<bool>& reversed) {
  std::vector<DriveUnit> units;
  for (std::vector<model::Share>& shares : model::shares(robot)) {
    const std::size_t i = units.size();
    units.push_back({std::to_string(i + 1), std::move(shares), !reversed.empty() && reversed[i]});
  }
  const std::vector<std::string> driven = model::variables(robot);
  for (const model::Motor& motor : robot.motors) {
    const auto place = std::find(driven.begin(), driven.end(), motor.variable) - driven.begin();
    units.push_back({"_" + motor.variable, {{static_cast<std::size_t>(place), 1}}});
  }
  return units;
}

/// Coulomb friction of a joint that several move acts by the direction of their sum, which is no argument.
bool has_column(DriveParameter kind, const DriveUnit& unit) {
  return kind != DriveParameter::coulomb_friction || unit.shares.size() == 1;
}

/// Writes the columns of drives, one entry for each coordinate.
class DriveColumns {
 public:
  DriveColumns(const model::Robot& robot, dag::Graph& graph)
      : coordinates_(model::coordinates(robot)), base_(model::base_motions(robot)), graph_(graph) {}

  std::vector<dag::Edge> entries(DriveParameter kind, const DriveUnit& unit) {
    std::vector<dag::Edge> column(coordinates_.size(), graph_.constant(0));
    for (const model::Share& share : unit.shares)
      column[base_ + share.driven] = force(kind, unit, share.ratio);
    return column;
  }

 private:
  /// Returns the force on a motor by a unit of the parameter; the drive has this ratio to the motor.
  dag::Edge force(DriveParameter kind, const DriveUnit& unit, const cln::cl_RA& ratio) {
    switch (kind) {
      case DriveParameter::rotor_inertia:
        return motion(ratio, unit, acceleration_of);
      case DriveParameter::viscous_friction:
        return motion(ratio, unit, velocity_of);
      case DriveParameter::coulomb_friction:
        return times(cln::abs(ratio), direction_of(coordinates_[base_ + unit.shares.front().driven]));
      case DriveParameter::offset:
        break;
    }
    return graph_.constant(exact::Number(unit.reversed ? -ratio : ratio));
  }
  /// The drive's own rate or acceleration, times a factor.
  dag::Edge motion(const cln::cl_RA& factor, const DriveUnit& unit, std::string (*of)(const std::string&)) {
    std::vector<dag::Edge> sum;
    for (const model::Share& share : unit.shares)
      sum.push_back(times(factor * share.ratio, of(coordinates_[base_ + share.driven])));
    return sum.size() == 1 ? sum.front() : graph_.sum(sum);
  }
  dag::Edge times(const cln::cl_RA& factor, const std::string& symbol) {
    return graph_.product({graph_.constant(exact::Number(factor)), graph_.symbol(symbol)});
  }

  std::vector<std::string> coordinates_;
  std::size_t base_;
  dag::Graph& graph_;
};

/// The columns of one kind of drive parameter; says so of drives that have none.
std::vector<DriveColumn> columns_of_drives(const model::Robot& robot, const std::vector<DriveUnit>& units,
                                           DriveParameter kind, DriveRegressor& result) {
  DriveColumns writer(robot, result.regressor.formulation.function.graph);
  std::vector<DriveColumn> columns;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::string name = short_names().at(kind) + units[i].suffix;
    if (has_column(kind, units[i]))
      columns.push_back({name, writer.entries(kind, units[i]),
                         result.regressor.base_parameters.graph.symbol(drive_parameter(i, kind))});
    else
      result.left_out.push_back(name +
                                " has no column, and counts for nothing: several motors move its joint");
  }
  return columns;
}

/// The order in which columns are kept: with offsets, the last ones, first no coefficient divides by gravity.
std::vector<std::size_t> order_of(std::size_t columns, std::size_t offset_count) {
  std::vector<std::size_t> order;
  const std::size_t offsets = columns - offset_count;
  for (std::size_t i = 0; i < offset_count; ++i) order.push_back(offsets + i);
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
  const Relations found =
      relations_of_columns(robot, {function_of(links.function.graph, compared), links.constants},
                           model::coordinate_count(robot), order_of(compared.size(), drive_count(robot)));
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
  DriveRegressor result{regressor(robot), {}, {}, {}};
  Regressor& regressor = result.regressor;
  std::vector<DriveColumn> columns = columns_of_links(regressor, model::coordinate_count(robot));
  const std::size_t links = columns.size();
  const std::vector<DriveUnit> units = units_of(robot, reversed);
  for (const DriveParameter kind : drive_parameters)
    for (DriveColumn& column : columns_of_drives(robot, units, kind, result))
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
