// SPDX-License-Identifier: MIT
#include "dag/rebuild.h"

namespace qvgen::dag {

std::vector<std::uint32_t> reachable(const Function& function) {
  std::vector<std::uint32_t> order;
  std::vector<bool> seen(function.graph.size(), false);
  std::vector<std::pair<std::uint32_t, std::size_t>> stack;
  const auto visit = [&](std::uint32_t id) {
    if (seen[id]) return;
    seen[id] = true;
    stack.emplace_back(id, 0);
  };
  for (const Output& output : function.outputs) {
    visit(output.value.node);
    while (!stack.empty()) {
      auto& [id, next] = stack.back();
      const Node& node = function.graph.node(id);
      if (next < node.operands.size()) {
        visit(node.operands[next++].node);
      } else {
        order.push_back(id);
        stack.pop_back();
      }
    }
  }
  return order;
}

Edge copy_node(const Graph& from, const Node& node, const std::vector<Edge>& operands, Graph& to) {
  switch (node.op) {
    case Op::constant:
      return to.constant(from.constant_of(node));
    case Op::symbol:
      return to.symbol(from.symbol_of(node));
    case Op::sine:
      return to.sine(from.angle_of(node));
    case Op::cosine:
      return to.cosine(from.angle_of(node));
    case Op::sum:
      return to.sum(operands);
    case Op::product:
      return to.product(operands);
    case Op::quotient:
      return to.quotient(operands[0], operands[1]);
    case Op::root:
      return to.root(operands[0]);
    case Op::arctangent:
      return to.arctangent(operands[0], operands[1]);
  }
  return {};
}

Edge copy_node_as_is(const Graph& from, const Node& node, const std::vector<Edge>& operands, Graph& to) {
  if (node.op == Op::sum || node.op == Op::product) return to.as_is(node.op, operands);
  return copy_node(from, node, operands, to);
}

Function rebuild(const Function& function, const Rewrite& rewrite) {
  Function result;
  std::vector<Edge> images(function.graph.size());
  const auto image = [&](Edge edge) { return edge.negative ? -images[edge.node] : images[edge.node]; };
  for (const std::uint32_t id : reachable(function)) {
    const Node& node = function.graph.node(id);
    std::vector<Edge> operands;
    for (const Edge& operand : node.operands) operands.push_back(image(operand));
    images[id] = rewrite(function.graph, node, operands, result.graph);
  }
  for (const Output& output : function.outputs) result.outputs.push_back({output.name, image(output.value)});
  return result;
}

}  // namespace qvgen::dag
