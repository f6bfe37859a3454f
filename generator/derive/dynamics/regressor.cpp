// SPDX-License-Identifier: MIT
#include "derive/dynamics/regressor.h"

#include <algorithm>
#include <map>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "exact/point.h"
#include "model/coordinates.h"
#include "passes/differentiate.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Number;
using Rows = std::vector<std::vector<Number>>;

bool mentions_inertia(const dag::Graph& graph, dag::Edge value) {
  const dag::Function single{graph, {{"", value}}};
  const auto nodes = dag::reachable(single);
  return std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t id) {
    return graph.node(id).op == dag::Op::symbol && graph.symbol_of(graph.node(id)).front() == '@';
  });
}

/// A place of the inertia matrices; `negative` if the constant is minus what stands there.
struct Entry {
  std::string name;
  bool negative = false;
};

/// "$7" -> "Sxy3", after the first place in the chain that it stands at.
std::map<std::string, Entry> names_of(const model::Robot& robot, const FrameConvention& convention) {
  dag::Graph graph;
  const Parametrisation p = parametrise(robot, convention, graph);
  const std::string axes = "xyz";
  std::map<std::string, Entry> result;
  for (const Link& link : p.chain.links)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = row; column < 4; ++column) {
        const dag::Edge edge = link.inertia.at(row, column).in(graph);
        const dag::Node& node = graph.node(edge);
        if (node.op != dag::Op::symbol) continue;
        const std::string kind = row == 3      ? "m"
                                 : column == 3 ? std::string("h") + axes[row]
                                               : std::string("S") + axes[row] + axes[column];
        const std::size_t body = link.motion == Motion::free ? 0 : link.joint + 1;
        result.emplace(graph.symbol_of(node), Entry{kind + std::to_string(body), edge.negative});
      }
  return result;
}

/// The outputs at a random point, one row per coordinate.
Rows rows_at(const dag::Function& function, std::size_t joints, std::uint64_t seed) {
  const auto values = dag::evaluate<Number>(function, exact::ExactPoint(seed));
  Rows rows(joints);
  for (std::size_t i = 0; i < values.size(); ++i) rows[i % joints].push_back(values[i]);
  return rows;
}

/// The columns of Y at two points, one below the other.
Rows columns_of(const dag::Function& function, std::size_t joints) {
  Rows columns;
  for (const std::uint64_t seed : {11U, 12U}) {
    const Rows rows = rows_at(function, joints, seed);
    columns.resize(rows.front().size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (const auto& row : rows) columns[k].push_back(row[k]);
  }
  return columns;
}

bool is_zero(const std::vector<Number>& column) {
  return std::all_of(column.begin(), column.end(), [](const Number& value) { return value.is_zero(); });
}

std::vector<Number> opposite(std::vector<Number> column) {
  for (Number& value : column) value = -value;
  return column;
}

/// Parameters without influence go; those with the same influence (Sxx and Syy of a first link) become one,
/// their sum.
void reduce(Regressor& result, std::size_t joints) {
  dag::Graph& graph = result.base_parameters.graph;
  const Rows columns = columns_of(result.formulation.function, joints);
  std::vector<dag::Output> entries, parameters;
  std::vector<std::string> names;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (is_zero(columns[k])) continue;
    const auto same = [&](std::size_t other) {
      return columns[other] == columns[k] || columns[other] == opposite(columns[k]);
    };
    const auto place = static_cast<std::size_t>(std::find_if(kept.begin(), kept.end(), same) - kept.begin());
    const dag::Edge parameter = result.base_parameters.outputs[k].value;
    if (place < kept.size()) {
      const bool negative = columns[kept[place]] != columns[k];
      parameters[place].value = graph.sum({parameters[place].value, negative ? -parameter : parameter});
      names[place] += (negative ? "-" : "+") + result.names[k];
      continue;
    }
    kept.push_back(k);
    names.push_back(result.names[k]);
    const std::string number = std::to_string(kept.size());
    parameters.push_back({"b" + number, parameter});
    for (std::size_t i = 0; i < joints; ++i)
      entries.push_back({"y" + std::to_string(i + 1) + "_" + number,
                         result.formulation.function.outputs[k * joints + i].value});
  }
  result.formulation.function.outputs = entries;
  result.base_parameters.outputs = parameters;
  result.names = names;
}

}  // namespace

Regressor regressor(const model::Robot& robot) {
  FormulationOptions choices;
  choices.convention.inertias = Inertias::standard;
  Regressor result;
  result.formulation = inverse_dynamics(robot, choices);
  dag::Function& function = result.formulation.function;
  std::erase_if(function.outputs, [](const dag::Output& output) { return output.name.front() == '?'; });
  const auto names = names_of(robot, choices.convention);
  std::vector<passes::Direction> directions;
  std::vector<bool> negative;
  result.base_parameters.graph = result.formulation.constants.graph;
  for (const dag::Output& constant : result.formulation.constants.outputs) {
    if (!mentions_inertia(result.formulation.constants.graph, constant.value)) continue;
    directions.push_back({constant.name, "y", directions.size() + 1});
    const Entry& entry = names.at(constant.name);
    result.base_parameters.outputs.push_back(
        {constant.name, entry.negative ? -constant.value : constant.value});
    result.names.push_back(entry.name);
    negative.push_back(entry.negative);
  }
  passes::append_derivatives(function, directions);
  const std::size_t joints = model::coordinate_count(robot);
  function.outputs.erase(function.outputs.begin(),
                         function.outputs.begin() + static_cast<std::ptrdiff_t>(joints));
  for (std::size_t i = 0; i < function.outputs.size(); ++i)
    if (negative[i / joints]) function.outputs[i].value = -function.outputs[i].value;
  reduce(result, joints);
  return result;
}

}  // namespace qvgen::derive::dynamics
