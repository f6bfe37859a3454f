// SPDX-License-Identifier: MIT
#include "compare/storage.h"

#include <algorithm>
#include <set>

#include "dag/rebuild.h"

namespace qvgen::compare {
namespace {

bool is_formulas_own(const dag::Graph& graph, const dag::Node& node) {
  if (node.op != dag::Op::constant) return false;
  const exact::Number& value = graph.constant_of(node);
  return value.is_zero() || value.is_one() || value == exact::Number(2) ||
         value == exact::Number(cln::cl_RA(1) / 2);
}

bool is_computed(const dag::Node& node) { return node.op != dag::Op::constant && node.op != dag::Op::symbol; }

}  // namespace

int most_alive(const dag::Function& function, const dag::IsFree& is_free) {
  const std::vector<bool> free = dag::free_nodes(function, is_free);
  std::vector<std::uint32_t> order = dag::reachable(function);
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> last_use(function.graph.size(), 0);
  for (const std::uint32_t id : order)
    for (const dag::Edge operand : function.graph.node(id).operands) last_use[operand.node] = id;
  for (const dag::Output& output : function.outputs) last_use[output.value.node] = function.graph.size();
  int alive = 0, most = 0;
  for (const std::uint32_t id : order) {
    const dag::Node& node = function.graph.node(id);
    if (free[id] || !is_computed(node)) continue;
    most = std::max(most, ++alive);
    const std::set<std::uint32_t> operands = [&] {
      std::set<std::uint32_t> set;
      for (const dag::Edge operand : node.operands) set.insert(operand.node);
      return set;
    }();
    for (const std::uint32_t operand : operands)
      if (last_use[operand] == id && !free[operand] && is_computed(function.graph.node(operand))) --alive;
  }
  return most;
}

int constants_of(const dag::Function& function, const dag::IsFree& is_free) {
  const std::vector<bool> free = dag::free_nodes(function, is_free);
  std::set<std::uint32_t> kept;
  const auto keep = [&](dag::Edge edge) {
    if (free[edge.node] && !is_formulas_own(function.graph, function.graph.node(edge)))
      kept.insert(edge.node);
  };
  for (const std::uint32_t id : dag::reachable(function))
    if (!free[id])
      for (const dag::Edge operand : function.graph.node(id).operands) keep(operand);
  for (const dag::Output& output : function.outputs) keep(output.value);
  return static_cast<int>(kept.size());
}

}  // namespace qvgen::compare
