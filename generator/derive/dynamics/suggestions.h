// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>

#include "derive/dynamics/scalar.h"

namespace qvgen::derive::dynamics {

/// Other ways to write values that a derivation uses: outputs "?0", "?1", ... that a search may draw on.
class Suggestions {
 public:
  explicit Suggestions(dag::Function& function) : function_(function) {}
  void operator()(std::initializer_list<Scalar> values) {
    for (const Scalar& value : values) add(value);
  }
  void operator()(const Vector3& values) {
    for (const Scalar& value : values) add(value);
  }

 private:
  void add(const Scalar& value) {
    if (value.is_zero()) return;
    function_.outputs.push_back({"?" + std::to_string(count_++), value.in(function_.graph)});
  }
  dag::Function& function_;
  std::size_t count_ = 0;
};

}  // namespace qvgen::derive::dynamics
