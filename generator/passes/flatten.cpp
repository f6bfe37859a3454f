// SPDX-License-Identifier: MIT
#include "dag/rebuild.h"
#include "passes/pass.h"
#include "passes/terms.h"

namespace qvgen::passes {

using dag::Edge;
using dag::Op;

dag::Function fold(const dag::Function& function) { return dag::rebuild(function); }

dag::Function flatten(const dag::Function& function) {
  const std::vector<int> uses = use_counts(function);
  // An inner node used once is opened; its operands stand in the new graph already. Which old node an operand
  // came from is not known to a rewrite, so the decision is taken on the old node's operands, position by
  // position.
  const auto rewrite = [&](const dag::Graph& from, const dag::Node& node, const std::vector<Edge>& operands,
                           dag::Graph& to) {
    if (node.op != Op::sum && node.op != Op::product) return dag::copy_node(from, node, operands, to);
    std::vector<Edge> flat;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const Edge operand = operands[i];
      const bool opens = uses[node.operands[i].node] == 1 && to.node(operand).op == node.op;
      if (!opens) {
        flat.push_back(operand);
        continue;
      }
      std::vector<Edge> inner = to.node(operand).operands;
      if (operand.negative && node.op == Op::sum)
        for (Edge& edge : inner) edge = -edge;
      if (operand.negative && node.op == Op::product) inner.front() = -inner.front();
      flat.insert(flat.end(), inner.begin(), inner.end());
    }
    return node.op == Op::sum ? to.sum(std::move(flat)) : to.product(std::move(flat));
  };
  return dag::rebuild(function, rewrite);
}

}  // namespace qvgen::passes
