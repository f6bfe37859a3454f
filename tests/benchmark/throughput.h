// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <qvgen/batch/machine.h>

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

/// The shortest time of one run, of several runs of some milliseconds each; of few if they take long.
template <class Work>
double shortest(const Work& work) {
  const double first = std::max(seconds(work), 1e-8);
  const int repeats = std::clamp(static_cast<int>(4e-3 / first), 1, 100000);
  const int rounds = std::clamp(static_cast<int>(1 / first), 2, 12);
  double best = first;
  for (int round = 0; round < rounds; ++round)
    best = std::min(best, seconds([&] {
                            for (int i = 0; i < repeats; ++i) work();
                          }) / repeats);
  return best;
}

/// An instruction set that batches are computed with.
struct Lanes {
  std::string name;
  qvgen::InstructionSet set;
};

/// Compared sets, the widest last: the sets with lanes that the machine has, or else the baseline.
inline std::vector<Lanes> lanes_of_machine() {
  using qvgen::InstructionSet;
  std::vector<Lanes> has;
  for (const Lanes& lanes : {Lanes{"NEON", InstructionSet::neon}, Lanes{"AVX2", InstructionSet::avx2},
                             Lanes{"AVX-512", InstructionSet::avx512}})
    if (qvgen::batch::machine_has(lanes.set)) has.push_back(lanes);
  if (has.empty()) has.push_back({"baseline", InstructionSet::baseline});
  return has;
}

/// Seconds a configuration.
struct Times {
  double single;
  std::vector<double> batch;  ///< by `lanes_of_machine`, on one thread
  double threads;             ///< a batch in the widest lanes, on all threads

  double widest() const { return batch.back(); }
};

/// The inverse kinematics of an arm: times in batches of so many poses, a share of them doubtful.
struct InverseOfArm {
  std::string name;
  std::function<Times(std::size_t, double)> measure;
};

inline std::vector<InverseOfArm>& inverse_of_arms() {
  static std::vector<InverseOfArm> all;
  return all;
}

}  // namespace throughput
