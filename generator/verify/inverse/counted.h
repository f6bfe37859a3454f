// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <qvgen/inverse/branch.h>

#include "dag/counts.h"

namespace qvgen::verify {

/// A number that counts what is done with it, by the project's rule: sign changes, comparisons and selections
/// are free.
class Counted {
 public:
  Counted() = default;
  Counted(double value) : value_(value) {}  // NOLINT(google-explicit-constructor)

  static dag::OperationCounts& tally() {
    static dag::OperationCounts counts;
    return counts;
  }

  Counted operator-() const { return {-value_}; }
  friend Counted operator+(const Counted& a, const Counted& b) {
    return ++tally().additions, a.value_ + b.value_;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return ++tally().additions, a.value_ - b.value_;
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return ++tally().multiplications, a.value_ * b.value_;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return ++tally().divisions, a.value_ / b.value_;
  }
  friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Counted& a, const Counted& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Counted& a, const Counted& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Counted& a, const Counted& b) { return a.value_ != b.value_; }
  friend Counted sqrt(const Counted& x) { return ++tally().roots, std::sqrt(x.value_); }
  friend Counted atan2(const Counted& y, const Counted& x) {
    return ++tally().arctangents, std::atan2(y.value_, x.value_);
  }

 private:
  double value_ = 0;
};

}  // namespace qvgen::verify

namespace qvgen::inverse {

template <>
struct ScalarTraits<verify::Counted> {
  using Mask = bool;
  static verify::Counted epsilon() { return {0x1p-52}; }
};

}  // namespace qvgen::inverse
