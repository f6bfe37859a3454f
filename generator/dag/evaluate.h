// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dag/graph.h"

namespace qvgen::dag {

/// Values of the outputs of a function over any number-like type.
///
/// Leaves: `constant(Number)`, `symbol(name)`, `sine(Angle)`, `cosine(Angle)` -> Value; inner nodes beyond
/// the four rules: `root(Value)`, `arctangent(Value y, Value x)`. Value needs + * / and unary minus.
template <class Value, class Leaves>
std::vector<Value> evaluate(const Function& function, Leaves&& leaves) {
  const Graph& graph = function.graph;
  std::vector<Value> values;
  values.reserve(graph.size());
  const auto at = [&](Edge edge) { return edge.negative ? Value(-values[edge.node]) : values[edge.node]; };
  const auto fold = [&](const Node& node, auto&& combine) {
    Value result = at(node.operands.front());
    for (std::size_t i = 1; i < node.operands.size(); ++i) result = combine(result, at(node.operands[i]));
    return result;
  };
  const auto value_of = [&](const Node& node) -> Value {
    switch (node.op) {
      case Op::constant:
        return leaves.constant(graph.constant_of(node));
      case Op::symbol:
        return leaves.symbol(graph.symbol_of(node));
      case Op::sine:
        return leaves.sine(graph.angle_of(node));
      case Op::cosine:
        return leaves.cosine(graph.angle_of(node));
      case Op::sum:
        return fold(node, [](const Value& a, const Value& b) { return Value(a + b); });
      case Op::product:
        return fold(node, [](const Value& a, const Value& b) { return Value(a * b); });
      case Op::quotient:
        return fold(node, [](const Value& a, const Value& b) { return Value(a / b); });
      case Op::root:
        return leaves.root(at(node.operands[0]));
      case Op::arctangent:
        return leaves.arctangent(at(node.operands[0]), at(node.operands[1]));
    }
    return Value{};
  };
  for (std::uint32_t id = 0; id < graph.size(); ++id) values.push_back(value_of(graph.node(id)));
  std::vector<Value> results;
  for (const Output& output : function.outputs) results.push_back(at(output.value));
  return results;
}

}  // namespace qvgen::dag
