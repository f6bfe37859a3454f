// SPDX-License-Identifier: MIT
#pragma once

// Random arms as people make them: axes along x, y and z, and many offsets of zero.
#include <cstdint>
#include <random>
#include <string>

namespace qvgen::test {

class RightAngled {
 public:
  RightAngled(std::uint32_t seed, int joints, int slides);

  [[nodiscard]] const std::string& text() const { return text_; }

  /// True if the velocities of all joints are independent at one of three places, by the reference's
  /// Jacobian.
  [[nodiscard]] bool moves_in_all_ways();

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }

  std::mt19937 random_;
  std::string text_;
};

}  // namespace qvgen::test
