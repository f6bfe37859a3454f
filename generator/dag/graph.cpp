// SPDX-License-Identifier: MIT
#include "dag/graph.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

#include "exact/hash.h"
#include "exact/trigonometry.h"

namespace qvgen::dag {

using exact::combine;
using exact::hash;
using exact::Number;

namespace {

/// Leaves come first, in an order a reader expects; inner nodes follow by structural hash.
int rank(Op op) {
  switch (op) {
    case Op::constant:
      return 0;
    case Op::symbol:
      return 1;
    case Op::cosine:
      return 2;
    case Op::sine:
      return 3;
    default:
      return 4;
  }
}

}  // namespace

bool Graph::precedes(Edge a, Edge b) const {
  const Node& x = nodes_[a.node];
  const Node& y = nodes_[b.node];
  if (rank(x.op) != rank(y.op)) return rank(x.op) < rank(y.op);
  if (x.op == Op::symbol && x.payload != y.payload) return symbols_[x.payload] < symbols_[y.payload];
  const bool angles = x.op == Op::sine || x.op == Op::cosine;
  if (angles && x.payload != y.payload) return to_string(angles_[x.payload]) < to_string(angles_[y.payload]);
  if (x.key != y.key) return x.key < y.key;
  return a.negative < b.negative;
}

Edge Graph::intern(Op op, std::uint32_t payload, std::uint64_t payload_key, std::vector<Edge> operands) {
  std::uint64_t key = combine(static_cast<std::uint64_t>(op) + 1, payload_key);
  for (const Edge& operand : operands)
    key = combine(key, nodes_[operand.node].key + (operand.negative ? 1 : 0));
  auto& candidates = index_[key];
  for (const std::uint32_t id : candidates) {
    const Node& known = nodes_[id];
    if (known.op == op && known.payload == payload && known.operands == operands) return {id, false};
  }
  const auto id = size();
  candidates.push_back(id);
  nodes_.push_back({op, payload, std::move(operands), key});
  return {id, false};
}

namespace {

template <class T>
std::uint32_t place_of(std::vector<T>& table, const T& value) {
  const auto place = std::find(table.begin(), table.end(), value) - table.begin();
  if (place == std::ssize(table)) table.push_back(value);
  return static_cast<std::uint32_t>(place);
}

}  // namespace

Edge Graph::constant(const Number& value) {
  const bool negative = value.sign() < 0;
  const Number size = negative ? -value : value;
  return {intern(Op::constant, place_of(constants_, size), hash(to_string(size)), {}).node, negative};
}

Edge Graph::symbol(const std::string& name) {
  return intern(Op::symbol, place_of(symbols_, name), hash(name), {});
}

Edge Graph::trigonometric(const exact::TrigonometricValue& value) {
  if (value.number) {
    const Edge edge = constant(*value.number);
    return value.negative ? -edge : edge;
  }
  const Op op = value.is_sine ? Op::sine : Op::cosine;
  return {intern(op, place_of(angles_, value.angle), hash(to_string(value.angle)), {}).node, value.negative};
}

Edge Graph::sine(const Angle& angle) { return trigonometric(exact::normalised_sine(angle)); }
Edge Graph::cosine(const Angle& angle) { return trigonometric(exact::normalised_cosine(angle)); }

Graph::Term Graph::term_of(Edge edge) const {
  Term term{Number(edge.negative ? -1 : 1), {edge.node, false}, {}};
  const Node& top = nodes_[edge.node];
  if (top.op != Op::product || nodes_[top.operands.front().node].op != Op::constant) return term;
  term.coefficient = term.coefficient * constants_[nodes_[top.operands.front().node].payload];
  term.factors.assign(top.operands.begin() + 1, top.operands.end());
  return term;
}

Edge Graph::scaled(const Number& coefficient, Edge base) {
  if (coefficient.is_one()) return base;
  if ((-coefficient).is_one()) return -base;
  return product({constant(coefficient), base});
}

Edge Graph::sum(std::vector<Edge> operands) {
  Number fixed;
  std::map<std::uint32_t, Number> coefficients;
  for (const Edge& operand : operands) {
    if (is_constant(operand)) {
      fixed = fixed + value_of(operand);
      continue;
    }
    const Term term = term_of(operand);
    const Edge base = term.factors.empty() ? term.base : product(term.factors);
    coefficients[base.node] =
        coefficients[base.node] + (base.negative ? -term.coefficient : term.coefficient);
  }
  std::vector<Edge> kept;
  if (!fixed.is_zero()) kept.push_back(constant(fixed));
  for (const auto& [base, coefficient] : coefficients)
    if (!coefficient.is_zero()) kept.push_back(scaled(coefficient, {base, false}));
  if (kept.empty()) return constant(0);
  if (kept.size() == 1) return kept.front();
  std::sort(kept.begin(), kept.end(), [this](Edge a, Edge b) { return precedes(a, b); });
  const bool negative = kept.front().negative;
  for (Edge& operand : kept) operand.negative = operand.negative != negative;
  return {intern(Op::sum, 0, 0, std::move(kept)).node, negative};
}

Edge Graph::product(std::vector<Edge> operands) {
  Number fixed(1);
  std::vector<Edge> kept;
  for (const Edge& operand : operands) {
    if (is_constant(operand)) {
      fixed = fixed * value_of(operand);
      continue;
    }
    const Term term = term_of(operand);
    fixed = fixed * term.coefficient;
    if (term.factors.empty()) kept.push_back(term.base);
    kept.insert(kept.end(), term.factors.begin(), term.factors.end());
  }
  if (fixed.is_zero()) return constant(0);
  const bool negative = fixed.sign() < 0;
  if (negative) fixed = -fixed;
  if (!fixed.is_one() || kept.empty()) kept.push_back(constant(fixed));
  if (kept.size() == 1) return negative ? -kept.front() : kept.front();
  std::sort(kept.begin(), kept.end(), [this](Edge a, Edge b) { return precedes(a, b); });
  return {intern(Op::product, 0, 0, std::move(kept)).node, negative};
}

Edge Graph::as_is(Op op, std::vector<Edge> operands) {
  std::sort(operands.begin(), operands.end(), [this](Edge a, Edge b) { return precedes(a, b); });
  bool negative = op == Op::sum && operands.front().negative;
  for (Edge& operand : operands) {
    if (op == Op::sum) {
      operand.negative = operand.negative != negative;
    } else {
      negative = negative != operand.negative;
      operand.negative = false;
    }
  }
  return {intern(op, 0, 0, std::move(operands)).node, negative};
}

Edge Graph::quotient(Edge numerator, Edge denominator) {
  if (is_constant(denominator)) return product({numerator, constant(value_of(denominator).inverse())});
  if (is_zero(numerator)) return numerator;
  const bool negative = numerator.negative != denominator.negative;
  numerator.negative = denominator.negative = false;
  if (numerator == denominator) return constant(negative ? -1 : 1);
  return {intern(Op::quotient, 0, 0, {numerator, denominator}).node, negative};
}

Edge Graph::root(Edge radicand) {
  if (is_constant(radicand) && value_of(radicand).is_rational() && !radicand.negative) {
    try {
      return constant(Number::root(value_of(radicand).rational()));
    } catch (const std::domain_error&) {
      // A radicand that is too long for an exact root, such as a rounded length of many digits, stays under
      // it.
    }
  }
  return intern(Op::root, 0, 0, {radicand});
}

Edge Graph::arctangent(Edge y, Edge x) { return intern(Op::arctangent, 0, 0, {y, x}); }

Number Graph::value_of(Edge edge) const {
  const Number& size = constants_[nodes_[edge.node].payload];
  return edge.negative ? -size : size;
}

bool Graph::is_zero(Edge edge) const { return is_constant(edge) && value_of(edge).is_zero(); }
bool Graph::is_one(Edge edge) const { return is_constant(edge) && value_of(edge).is_one(); }

}  // namespace qvgen::dag
