// SPDX-License-Identifier: MIT
#include "compare/recorder.h"

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

Value Recorder::sum(const Value& a, const Value& b) {
  ++asked_.additions;
  return {*this, graph_.sum({a.edge(), b.edge()})};
}

Value Recorder::product(const Value& a, const Value& b) {
  ++asked_.multiplications;
  return {*this, graph_.product({a.edge(), b.edge()})};
}

}  // namespace qvgen::compare
