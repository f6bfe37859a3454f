// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "dag/rebuild.h"
#include "passes/pass.h"
#include "passes/terms.h"

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Graph;

struct Choice {
  std::uint32_t factor = 0;
  int terms = 0;
};

/// The factor that most terms contain; equal counts are decided by structure.
Choice most_frequent(const Graph& graph, const std::vector<Term>& terms) {
  std::map<std::uint32_t, int> frequency;
  for (const Term& term : terms) {
    std::uint32_t last = UINT32_MAX;
    for (const std::uint32_t factor : term.factors)
      if (factor != last) ++frequency[last = factor];
  }
  Choice best;
  for (const auto& [factor, count] : frequency) {
    const bool better =
        count > best.terms || (count == best.terms && graph.node(factor).key < graph.node(best.factor).key);
    if (better) best = {factor, count};
  }
  return best;
}

void drop_one(Term& term, std::uint32_t factor) {
  term.factors.erase(std::find(term.factors.begin(), term.factors.end(), factor));
}

Edge factored(Graph& graph, std::vector<Term> terms) {
  const Choice choice = most_frequent(graph, terms);
  if (choice.terms < 2) return to_edge(graph, terms);
  std::vector<Term> inside;
  std::vector<Term> outside;
  for (Term& term : terms) {
    const bool has = std::find(term.factors.begin(), term.factors.end(), choice.factor) != term.factors.end();
    if (has) drop_one(term, choice.factor);
    (has ? inside : outside).push_back(std::move(term));
  }
  const Edge product = graph.product({{choice.factor, false}, factored(graph, std::move(inside))});
  if (outside.empty()) return product;
  return graph.sum({product, factored(graph, std::move(outside))});
}

}  // namespace

dag::Function factor(const dag::Function& function) {
  const auto rewrite = [](const Graph& from, const dag::Node& node, const std::vector<Edge>& operands,
                          Graph& to) {
    if (node.op != dag::Op::sum) return dag::copy_node(from, node, operands, to);
    return factored(to, terms_of_sum(to, operands));
  };
  return dag::rebuild(function, rewrite);
}

}  // namespace qvgen::passes
