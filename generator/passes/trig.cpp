// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "dag/rebuild.h"
#include "passes/pass.h"
#include "passes/terms.h"

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Graph;
using dag::Op;
using Factors = std::vector<std::uint32_t>;

bool is_trigonometric(const Graph& graph, std::uint32_t id) {
  return graph.node(id).op == Op::sine || graph.node(id).op == Op::cosine;
}

/// The cosine of the angle whose sine a node is, and the other way round.
std::uint32_t partner(Graph& graph, std::uint32_t id) {
  const dag::Angle angle = graph.angle_of(graph.node(id));
  return (graph.node(id).op == Op::sine ? graph.cosine(angle) : graph.sine(angle)).node;
}

Factors without_square(const Factors& factors, std::uint32_t square) {
  Factors rest;
  int dropped = 0;
  for (const std::uint32_t factor : factors)
    if (factor == square && dropped < 2)
      ++dropped;
    else
      rest.push_back(factor);
  return rest;
}

Factors with_square(Factors factors, std::uint32_t square) {
  factors.insert(factors.end(), 2, square);
  std::sort(factors.begin(), factors.end());
  return factors;
}

std::vector<std::uint32_t> squares_in(const Graph& graph, const Factors& factors) {
  std::vector<std::uint32_t> squares;
  for (std::size_t i = 0; i + 1 < factors.size(); ++i)
    if (factors[i] == factors[i + 1] && is_trigonometric(graph, factors[i])) squares.push_back(factors[i]);
  return squares;
}

std::optional<std::size_t> find(const std::vector<Term>& terms, const Factors& factors,
                                const exact::Number& coefficient) {
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (terms[i].factors == factors && terms[i].coefficient == coefficient) return i;
  return std::nullopt;
}

/// Applies one rule to one pair of terms; false where none applies.
bool reduce_once(Graph& graph, std::vector<Term>& terms) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (const std::uint32_t square : squares_in(graph, terms[i].factors)) {
      const std::uint32_t other = partner(graph, square);
      const Factors rest = without_square(terms[i].factors, square);
      // k x s^2 + k x c^2 = k x
      if (const auto j = find(terms, with_square(rest, other), terms[i].coefficient)) {
        terms[i].factors = rest;
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(*j));
        return true;
      }
      // k x - k x s^2 = k x c^2
      if (const auto j = find(terms, rest, -terms[i].coefficient)) {
        terms[*j].factors = with_square(rest, other);
        terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    }
  }
  return false;
}

}  // namespace

dag::Function trig(const dag::Function& function) {
  const auto rewrite = [](const Graph& from, const dag::Node& node, const std::vector<Edge>& operands,
                          Graph& to) {
    if (node.op != Op::sum) return dag::copy_node(from, node, operands, to);
    std::vector<Term> terms = terms_of_sum(to, operands);
    bool changed = false;
    while (reduce_once(to, terms)) changed = true;
    return changed ? to_edge(to, terms) : to.sum(operands);
  };
  return dag::rebuild(function, rewrite);
}

}  // namespace qvgen::passes
