// SPDX-License-Identifier: MIT
#include "emit/math/collect.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "exact/number.h"

namespace qvgen::emit {
namespace {

using dag::Edge;
using dag::Graph;
using dag::Op;
using exact::Number;

/// Node -> exponent.
using Powers = std::map<std::uint32_t, int>;

struct Term {
  Number coefficient;
  Powers powers;
};
using Terms = std::vector<Term>;

bool is_trigonometric(const Graph& graph, std::uint32_t node) {
  return graph.node(node).op == Op::sine || graph.node(node).op == Op::cosine;
}

void multiply(const Graph& graph, Edge edge, Term& term) {
  const dag::Node& node = graph.node(edge);
  if (edge.negative) term.coefficient = -term.coefficient;
  if (node.op == Op::constant)
    term.coefficient = term.coefficient * graph.constant_of(node);
  else if (node.op == Op::product)
    for (const Edge& factor : node.operands) multiply(graph, factor, term);
  else
    ++term.powers[edge.node];
}

Terms terms_of(const Graph& graph, Edge sum) {
  std::vector<Edge> edges{sum};
  if (graph.node(sum).op == Op::sum) {
    edges = graph.node(sum).operands;
    for (Edge& edge : edges) edge.negative = edge.negative != sum.negative;
  }
  Terms terms;
  for (const Edge& edge : edges) {
    Term term{Number(1), {}};
    multiply(graph, edge, term);
    terms.push_back(term);
  }
  return terms;
}

Powers common_powers(const Terms& terms) {
  Powers common = terms.front().powers;
  for (const Term& term : terms)
    for (auto& [node, power] : common) {
      const auto place = term.powers.find(node);
      power = place == term.powers.end() ? 0 : std::min(power, place->second);
    }
  std::erase_if(common, [](const auto& entry) { return entry.second == 0; });
  return common;
}

void divide(Powers& powers, const Powers& by) {
  for (const auto& [node, power] : by)
    if ((powers[node] -= power) == 0) powers.erase(node);
}

/// Two factors of one term that the other lacks, sines and cosines.
struct Pair {
  std::uint32_t first, second;
};

std::optional<Pair> pair_of(const Graph& graph, const Powers& powers) {
  if (powers.size() != 2) return std::nullopt;
  for (const auto& [node, power] : powers)
    if (power != 1 || !is_trigonometric(graph, node)) return std::nullopt;
  return Pair{powers.begin()->first, powers.rbegin()->first};
}

/// cos a cos b -+ sin a sin b and sin a cos b +- cos a sin b, a multiple of each: the function of a sum.
std::optional<Edge> in_one(Graph& graph, Pair one, Pair other, bool same_sign) {
  const auto angle = [&](std::uint32_t node) { return graph.angle_of(graph.node(node)); };
  const auto is_sine = [&](std::uint32_t node) { return graph.node(node).op == Op::sine; };
  if (angle(one.first) != angle(other.first)) std::swap(other.first, other.second);
  if (angle(one.first) != angle(other.first) || angle(one.second) != angle(other.second)) return std::nullopt;
  if (is_sine(one.first) == is_sine(other.first) || is_sine(one.second) == is_sine(other.second))
    return std::nullopt;
  if (!is_sine(one.first) && is_sine(one.second)) std::swap(one.first, one.second);
  const bool is_cosine = is_sine(one.first) == is_sine(one.second);
  const bool plus = is_cosine != same_sign;
  const dag::Angle sum = angle(one.first) + cln::cl_RA(plus ? 1 : -1) * angle(one.second);
  const Edge result = is_cosine ? graph.cosine(sum) : graph.sine(sum);
  const bool negative = is_cosine && is_sine(one.first) && plus;
  return negative ? -result : result;
}

/// One pair of terms less; false if there is none.
bool contract(Graph& graph, Terms& terms) {
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const bool same_sign = terms[i].coefficient == terms[j].coefficient;
      if (!same_sign && terms[i].coefficient != -terms[j].coefficient) continue;
      const Powers common = common_powers({terms[i], terms[j]});
      Powers one = terms[i].powers;
      Powers other = terms[j].powers;
      divide(one, common);
      divide(other, common);
      const auto first = pair_of(graph, one);
      const auto second = pair_of(graph, other);
      if (!first || !second) continue;
      const auto sum = in_one(graph, *first, *second, same_sign);
      if (!sum) continue;
      Term term{terms[i].coefficient, common};
      multiply(graph, *sum, term);
      terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(j));
      terms[i] = term;
      return true;
    }
  return false;
}

/// a - a sin^2: a cos^2; false if there is none.
bool complement(Graph& graph, Terms& terms) {
  for (const Term& with : terms)
    for (const auto& [node, power] : with.powers) {
      if (power != 2 || graph.node(node).op != Op::sine) continue;
      Powers without = with.powers;
      without.erase(node);
      const auto constant = std::find_if(terms.begin(), terms.end(), [&](const Term& term) {
        return term.powers == without && term.coefficient == -with.coefficient;
      });
      if (constant == terms.end()) continue;
      Term result = *constant;
      result.powers[graph.cosine(graph.angle_of(graph.node(node))).node] += 2;
      const auto gone = [&](const Term& term) { return &term == &with || &term == &*constant; };
      Terms rest;
      for (const Term& term : terms)
        if (!gone(term)) rest.push_back(term);
      rest.push_back(result);
      terms = rest;
      return true;
    }
  return false;
}

bool is_small(const Number& number) {
  return number.is_rational() && cln::abs(cln::numerator(number.rational())) <= 8 &&
         cln::denominator(number.rational()) <= 8;
}

/// A number that most of the terms have, all of them or (of small ones) more than half.
Number common_number(const Terms& terms) {
  const auto size = [](const Number& number) { return number.sign() < 0 ? -number : number; };
  for (const Term& candidate : terms) {
    const Number number = size(candidate.coefficient);
    const auto count = std::count_if(terms.begin(), terms.end(),
                                     [&](const Term& term) { return size(term.coefficient) == number; });
    const bool all = static_cast<std::size_t>(count) == terms.size();
    if (all || (is_small(number) && 2 * static_cast<std::size_t>(count) > terms.size())) return number;
  }
  return Number(1);
}

class Builder {
 public:
  explicit Builder(Graph& graph) : graph_(graph) {}

  Edge build(Terms terms) {
    if (terms.empty()) return graph_.constant(Number(0));
    const Powers common = common_powers(terms);
    if (terms.size() == 1) return monomial(terms.front());
    const Number number = common_number(terms);
    for (Term& term : terms) {
      divide(term.powers, common);
      term.coefficient = term.coefficient / number;
    }
    const Edge inner = graph_.sum(summands(terms));
    if (common.empty() && number.is_one()) return inner;
    return graph_.product({monomial({number, common}), inner});
  }

 private:
  std::vector<Edge> summands(const Terms& terms) {
    const auto factor = most_frequent(terms);
    std::vector<Edge> edges;
    if (!factor) {
      for (const Term& term : terms) edges.push_back(monomial(term));
      return edges;
    }
    Terms with;
    Terms without;
    for (const Term& term : terms) (has(term, *factor) ? with : without).push_back(term);
    edges.push_back(build(with));
    if (without.empty()) return edges;
    for (const Edge& edge : summands(without)) edges.push_back(edge);
    return edges;
  }

  static bool has(const Term& term, const std::pair<std::uint32_t, int>& factor) {
    const auto place = term.powers.find(factor.first);
    return place != term.powers.end() && place->second == factor.second;
  }

  /// The power that stands in most terms, in two at least; one of a sine or cosine before others.
  [[nodiscard]] std::optional<std::pair<std::uint32_t, int>> most_frequent(const Terms& terms) const {
    std::map<std::pair<std::uint32_t, int>, int> counts;
    for (const Term& term : terms)
      for (const auto& factor : term.powers) ++counts[{factor.first, factor.second}];
    std::optional<std::pair<std::uint32_t, int>> best;
    std::tuple<bool, int> value{false, 1};
    for (const auto& [factor, count] : counts) {
      const std::tuple<bool, int> now{is_trigonometric(graph_, factor.first), count};
      if (count < 2 || now <= value) continue;
      best = factor;
      value = now;
    }
    return best;
  }

  Edge monomial(const Term& term) {
    std::vector<Edge> factors{graph_.constant(term.coefficient)};
    for (const auto& [node, power] : term.powers) factors.insert(factors.end(), std::size_t(power), {node});
    return graph_.product(factors);
  }

  Graph& graph_;
};

}  // namespace

dag::Function collected(dag::Function function) {
  Graph& graph = function.graph;
  for (dag::Output& output : function.outputs) {
    Terms terms = terms_of(graph, output.value);
    while (contract(graph, terms) || complement(graph, terms)) continue;
    output.value = Builder(graph).build(terms);
  }
  return function;
}

}  // namespace qvgen::emit
