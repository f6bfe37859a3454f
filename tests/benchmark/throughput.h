// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

/// Times of batches.
namespace throughput {

/// Seconds.
template <class Work>
double seconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The shortest time of one run, of several runs of some milliseconds each.
template <class Work>
double shortest(const Work& work) {
  const double first = std::max(seconds(work), 1e-8);
  const int repeats = std::clamp(static_cast<int>(4e-3 / first), 1, 100000);
  double best = first;
  for (int round = 0; round < 12; ++round)
    best = std::min(best, seconds([&] {
                            for (int i = 0; i < repeats; ++i) work();
                          }) / repeats);
  return best;
}

/// Measures the inverse kinematics of an arm each, in batches of so many poses.
inline std::vector<void (*)(std::size_t)>& inverse_of_arms() {
  static std::vector<void (*)(std::size_t)> all;
  return all;
}

}  // namespace throughput
