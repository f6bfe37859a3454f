// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/polish.h>

namespace qvgen::inverse {

/// What has come of each branch, and the solutions so far by the values of the joints that decide: the closed form may
/// come to one from two branches, and polishing brings two together where they are one.
template <typename Scalar, std::size_t joints, std::size_t capacity>
class Visited {
 public:
  [[nodiscard]] bool settled(int branch) const { return settled_[static_cast<std::size_t>(branch)]; }
  /// Whether some branch came near a solution and has none.
  [[nodiscard]] bool misses_any() const { return misses_any_; }
  void begin_pass() { misses_any_ = false; }

  /// Takes note of where a branch has led; true if that is a solution and a new one, to half the digits.
  bool take(int branch, bool reached, const JointValues<Scalar, joints>& values) {
    misses_any_ = misses_any_ || !reached;
    if (!reached) return false;
    settled_[static_cast<std::size_t>(branch)] = true;
    for (std::size_t k = 0; k < count_; ++k)
      if (same(rows_[k], values)) return false;
    rows_[count_++] = values;
    return true;
  }

 private:
  static bool same(const JointValues<Scalar, joints>& a, const JointValues<Scalar, joints>& b) {
    Scalar sum(0);
    for (std::size_t i = 0; i < joints; ++i) {
      const Scalar x = a[i].cosine - b[i].cosine;
      const Scalar y = a[i].sine - b[i].sine;
      sum += x * x + y * y;
    }
    return sum < Scalar(180) * epsilon<Scalar>();
  }

  std::array<bool, capacity> settled_{};
  std::array<JointValues<Scalar, joints>, capacity> rows_;
  std::size_t count_ = 0;
  bool misses_any_ = false;
};

}  // namespace qvgen::inverse
