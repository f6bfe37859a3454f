// SPDX-License-Identifier: MIT
#include "passes/differentiate.h"

#include <stdexcept>

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Graph;
using dag::Node;
using dag::Op;

class Differentiator {
 public:
  Differentiator(Graph& graph, const std::string& symbol)
      : graph_(graph), symbol_(symbol), zero_(graph.constant(0)) {}

  std::vector<Edge> run(std::uint32_t size) {
    for (std::uint32_t id = 0; id < size; ++id) rates_.push_back(rate_of(Node(graph_.node(id)), id));
    return std::move(rates_);
  }

 private:
  Edge rate(Edge edge) const { return edge.negative ? -rates_[edge.node] : rates_[edge.node]; }

  Edge rate_of(const Node& node, std::uint32_t id) {
    switch (node.op) {
      case Op::constant:
        return zero_;
      case Op::symbol:
        return graph_.constant(graph_.symbol_of(node) == symbol_ ? 1 : 0);
      case Op::sine:
      case Op::cosine:
        return of_circular(node);
      case Op::sum:
        return of_sum(node);
      case Op::product:
        return of_product(node);
      case Op::quotient:
        return of_quotient(node, id);
      default:
        throw std::domain_error("no derivative of a root or an arctangent");
    }
  }

  Edge of_circular(const Node& node) {
    const dag::Angle angle = graph_.angle_of(node);
    const auto term = angle.terms.find(symbol_);
    if (term == angle.terms.end()) return zero_;
    const Edge factor = graph_.constant(exact::Number(term->second));
    return node.op == Op::sine ? graph_.product({factor, graph_.cosine(angle)})
                               : -graph_.product({factor, graph_.sine(angle)});
  }

  Edge of_sum(const Node& node) {
    std::vector<Edge> rates;
    for (const Edge operand : node.operands)
      if (!graph_.is_zero(rate(operand))) rates.push_back(rate(operand));
    return rates.empty() ? zero_ : rates.size() == 1 ? rates.front() : graph_.sum(rates);
  }

  Edge of_product(const Node& node) {
    std::vector<Edge> terms;
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
      if (graph_.is_zero(rate(node.operands[i]))) continue;
      std::vector<Edge> factors = node.operands;
      factors[i] = rate(node.operands[i]);
      terms.push_back(graph_.product(factors));
    }
    return terms.empty() ? zero_ : terms.size() == 1 ? terms.front() : graph_.sum(terms);
  }

  /// (a/b)' = (a' - (a/b) b')/b.
  Edge of_quotient(const Node& node, std::uint32_t id) {
    const Edge over = rate(node.operands[0]), under = rate(node.operands[1]);
    if (graph_.is_zero(over) && graph_.is_zero(under)) return zero_;
    const Edge value{id, false};
    return graph_.quotient(graph_.sum({over, -graph_.product({value, under})}), node.operands[1]);
  }

  Graph& graph_;
  const std::string& symbol_;
  Edge zero_;
  std::vector<Edge> rates_;
};

}  // namespace

std::vector<Edge> derivatives(Graph& graph, std::uint32_t size, const std::string& symbol) {
  return Differentiator(graph, symbol).run(size);
}

void append_derivatives(dag::Function& function, const std::vector<Direction>& directions) {
  const std::vector<dag::Output> outputs = function.outputs;
  const std::uint32_t size = function.graph.size();
  for (const Direction& direction : directions) {
    const std::vector<Edge> rates = derivatives(function.graph, size, direction.symbol);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const Edge rate = rates[outputs[i].value.node];
      const std::string name =
          direction.prefix + std::to_string(i + 1) + "_" + std::to_string(direction.number);
      function.outputs.push_back({name, outputs[i].value.negative ? -rate : rate});
    }
  }
}

}  // namespace qvgen::passes
