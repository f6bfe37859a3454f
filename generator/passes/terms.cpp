// SPDX-License-Identifier: MIT
#include "passes/terms.h"

#include <algorithm>

#include "dag/rebuild.h"

namespace qvgen::passes {

using dag::Edge;
using dag::Graph;
using dag::Op;

namespace {

Term term_of(const Graph& graph, Edge edge) {
  Term term{exact::Number(edge.negative ? -1 : 1), {}};
  const dag::Node& node = graph.node(edge);
  if (node.op == Op::constant) {
    term.coefficient = graph.value_of(edge);
    return term;
  }
  if (node.op != Op::product) {
    term.factors.push_back(edge.node);
    return term;
  }
  for (const Edge& operand : node.operands) {
    if (graph.is_constant(operand))
      term.coefficient = term.coefficient * graph.value_of(operand);
    else
      term.factors.push_back(operand.node);
  }
  std::sort(term.factors.begin(), term.factors.end());
  return term;
}

}  // namespace

std::vector<Term> terms_of_sum(const Graph& graph, const std::vector<Edge>& operands) {
  std::vector<Term> terms;
  for (const Edge& operand : operands) terms.push_back(term_of(graph, operand));
  return terms;
}

Edge to_edge(Graph& graph, const Term& term) {
  std::vector<Edge> operands{graph.constant(term.coefficient)};
  for (const std::uint32_t factor : term.factors) operands.push_back({factor, false});
  return graph.product(std::move(operands));
}

Edge to_edge(Graph& graph, const std::vector<Term>& terms) {
  std::vector<Edge> operands;
  for (const Term& term : terms) operands.push_back(to_edge(graph, term));
  return graph.sum(std::move(operands));
}

std::vector<int> use_counts(const dag::Function& function) {
  std::vector<int> counts(function.graph.size(), 0);
  for (const std::uint32_t id : dag::reachable(function))
    for (const Edge& operand : function.graph.node(id).operands) ++counts[operand.node];
  for (const dag::Output& output : function.outputs) ++counts[output.value.node];
  return counts;
}

}  // namespace qvgen::passes
