// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "derive/dynamics/scalar.h"
#include "exact/number.h"

namespace qvgen::derive::dynamics {

/// Gives every distinct value of one graph a symbol "$0", "$1", ... of another one: what is computed from
/// constants alone is a constant then. Values are compared exactly, at random points: zeros and ones stay
/// numbers, equal and opposite values share a symbol.
class Naming {
 public:
  Naming(dag::Graph source, std::vector<dag::Edge> values, dag::Graph& target);

  /// The value of that index as a number or a symbol of the target graph.
  Scalar name(std::size_t index);
  /// The function of the source graph with an output for each symbol.
  dag::Function take() { return std::move(constants_); }

 private:
  [[nodiscard]] std::string key_of(std::size_t index, bool negative) const;

  dag::Graph& target_;
  dag::Function constants_;
  std::vector<dag::Edge> edges_;
  /// At three points: at one of them two values may agree by chance, for its numbers are short.
  std::array<std::vector<exact::Number>, 3> values_;
  std::map<std::string, std::string> known_;
};

}  // namespace qvgen::derive::dynamics
