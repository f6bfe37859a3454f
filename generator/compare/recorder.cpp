// SPDX-License-Identifier: MIT
#include "compare/recorder.h"

#include <optional>
#include <utility>
#include <vector>

namespace qvgen::compare {
namespace {

constexpr char opaque_mark = '$';

}  // namespace

bool is_opaque(const std::string& symbol) { return symbol.front() == opaque_mark; }

Value operator+(const Value& a, const Value& b) { return a.recorder_->sum(a, b); }
Value operator*(const Value& a, const Value& b) { return a.recorder_->product(a, b); }

Value Recorder::opaque(dag::Edge meaning) {
  if (entries_ == Entries::known) return {*this, meaning};
  const std::string name = opaque_mark + std::to_string(kept_.size());
  kept_.emplace(name, meaning);
  return {*this, graph_.symbol(name)};
}

Value Recorder::stored(const Exact& number) {
  ++stored_;
  return opaque(number.in(graph_));
}

Value Recorder::entry(long number) { return opaque(graph_.constant(number)); }

Value Recorder::literal(const cln::cl_RA& number) { return {*this, graph_.constant(number)}; }

Value Recorder::argument(const std::string& name) { return {*this, graph_.symbol(name)}; }

Recorder::Circle Recorder::circle(const dag::Angle& angle) {
  ++asked_.sine_cosines;
  return {{*this, graph_.cosine(angle)}, {*this, graph_.sine(angle)}};
}

namespace {

/// Returns what is left of a sum to which one of its own terms is added with the other sign: (1 - c) + c, as
/// Rodrigues' formula has it about a coordinate axis.
std::optional<dag::Edge> without_cancelled(dag::Graph& graph, dag::Edge sum, dag::Edge added) {
  const dag::Node node = graph.node(sum);
  if (node.op != dag::Op::sum) return std::nullopt;
  std::vector<dag::Edge> rest;
  for (const dag::Edge operand : node.operands) {
    const dag::Edge term = sum.negative ? -operand : operand;
    if (!(term == -added)) rest.push_back(term);
  }
  if (rest.size() == node.operands.size()) return std::nullopt;
  return graph.sum(rest);
}

}  // namespace

Value Recorder::sum(const Value& a, const Value& b) {
  ++asked_.additions;
  if (entries_ == Entries::known)
    for (const auto& [sum, added] : {std::pair{a.edge(), b.edge()}, {b.edge(), a.edge()}})
      if (const auto rest = without_cancelled(graph_, sum, added)) return {*this, *rest};
  return {*this, graph_.sum({a.edge(), b.edge()})};
}

Value Recorder::product(const Value& a, const Value& b) {
  ++asked_.multiplications;
  return {*this, graph_.product({a.edge(), b.edge()})};
}

}  // namespace qvgen::compare
