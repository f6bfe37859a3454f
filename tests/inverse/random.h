// SPDX-License-Identifier: MIT
#pragma once

#include <random>

namespace qvgen::test {

/// Numbers that are the same in every run.
struct Random {
  std::mt19937_64 engine{7};
  double operator()(double low = -1, double high = 1) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
};

}  // namespace qvgen::test
