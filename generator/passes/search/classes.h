// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dag/angle.h"
#include "dag/graph.h"
#include "exact/number.h"
#include "passes/search/field.h"

namespace qvgen::passes::search_detail {

/// A value class or its negative.
struct Ref {
  std::uint32_t id = 0;
  bool negative = false;
  Ref operator-() const { return signed_by(true); }
  /// Zero, class 0, is its own negative and has one sign only.
  Ref signed_by(bool flip) const { return {id, id != 0 && negative != flip}; }
  friend bool operator==(const Ref&, const Ref&) = default;
};

/// One way to compute a class from others: value = (-1)^negative op(a, b). Unary operations leave b = a.
struct ENode {
  dag::Op op;
  bool negative = false;
  Ref a, b;
  friend bool operator==(const ENode&, const ENode&) = default;
};

/// Meaning of a leaf; a sine or cosine names its angle by index.
struct Leaf {
  dag::Op op;
  exact::Number number;
  std::string symbol;
  std::uint32_t angle = 0;
  bool negative = false;  ///< the class is minus the leaf
};

/// All subexpressions with the same value up to sign (at a random point of a large field), with every
/// known way to compute that value. Classes 0 and 1 are the numbers 0 and 1. Classes are numbered in order of
/// creation, which depends on the inputs alone.
struct EClass {
  Field value;
  std::optional<Leaf> leaf;
  bool free = false;  ///< constants and free symbols alone: costs nothing
  std::vector<ENode> nodes;
};

class Classes {
 public:
  static constexpr std::uint32_t zero = 0, one = 1;

  Classes();
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(classes_.size()); }
  [[nodiscard]] const EClass& operator[](std::uint32_t id) const { return classes_[id]; }
  [[nodiscard]] Field value(Ref ref) const {
    return ref.negative ? -classes_[ref.id].value : classes_[ref.id].value;
  }
  /// The class of a value, if there is one.
  [[nodiscard]] std::optional<Ref> find(Field value) const;

  Ref leaf(Leaf leaf, Field value, bool free);
  Ref sum(Ref a, Ref b);
  Ref product(Ref a, Ref b);
  Ref quotient(Ref a, Ref b);
  Ref opaque(dag::Op op, Ref a, Ref b, Field value);
  /// Marks every class as free that has a node from free ones.
  void propagate_free();

 private:
  Ref intern(Field value);
  Ref define(Field value, ENode node);
  void grow();
  [[nodiscard]] std::size_t slot(Field key) const;

  std::vector<EClass> classes_;
  std::vector<std::uint32_t> table_;  ///< open addressing over the canonical of value, -value; empty = none
};

}  // namespace qvgen::passes::search_detail
