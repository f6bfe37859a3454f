// SPDX-License-Identifier: MIT
#include "dag/counts.h"

#include <algorithm>
#include <set>

#include "dag/rebuild.h"
#include "exact/constant_angle.h"

namespace qvgen::dag {

bool is_free(const Angle& angle, const IsFree& is_free_symbol) {
  return std::all_of(angle.terms.begin(), angle.terms.end(),
                     [&](const auto& term) { return is_free_symbol && is_free_symbol(term.first); });
}

std::vector<bool> free_nodes(const Function& function, const IsFree& is_free) {
  const Graph& graph = function.graph;
  std::vector<bool> free(graph.size(), false);
  if (!is_free) return free;
  for (std::uint32_t id = 0; id < graph.size(); ++id) {
    const Node& node = graph.node(id);
    if (node.op == Op::constant)
      free[id] = true;
    else if (node.op == Op::symbol)
      free[id] = is_free(graph.symbol_of(node));
    else if (node.op == Op::sine || node.op == Op::cosine)
      free[id] = dag::is_free(graph.angle_of(node), is_free);
    else
      free[id] =
          std::all_of(node.operands.begin(), node.operands.end(), [&](Edge e) { return free[e.node]; });
  }
  return free;
}

OperationCounts count(const Function& function, const IsFree& is_free) {
  OperationCounts counts;
  std::set<std::string> angles;
  const std::vector<bool> free = free_nodes(function, is_free);
  for (const std::uint32_t id : reachable(function)) {
    if (free[id]) continue;
    const Node& node = function.graph.node(id);
    const int terms = static_cast<int>(node.operands.size());
    switch (node.op) {
      case Op::constant:
      case Op::symbol:
        break;
      case Op::sine:
      case Op::cosine:
        if (!exact::radians(function.graph.angle_of(node)))
          angles.insert(to_string(function.graph.angle_of(node)));
        break;
      case Op::sum:
        counts.additions += terms - 1;
        break;
      case Op::product:
        counts.multiplications += terms - 1;
        break;
      case Op::quotient:
        ++counts.divisions;
        break;
      case Op::root:
        ++counts.roots;
        break;
      case Op::arctangent:
        ++counts.arctangents;
        break;
    }
  }
  counts.sine_cosines = static_cast<int>(angles.size());
  return counts;
}

}  // namespace qvgen::dag
