// SPDX-License-Identifier: MIT
// Times and checks five functions of a robot in three implementations.
//
//     main STATES MODEL                  a line a function: name, ns a call of each library, and the largest
//                                        difference of the others from the first
//     main STATES MODEL LIBRARY NAME N   calls one function N times, for valgrind
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "implementation.h"

namespace {

using namespace qvgen::benchmark::trees;
using Numbers = std::vector<double>;

Robot read(const std::string& file) {
  std::ifstream in(file);
  Robot robot{};
  std::size_t joints = 0, states = 0, positions = 0;
  in >> robot.size >> robot.floating >> joints >> states;
  positions = robot.size + (robot.floating ? 1 : 0);
  robot.joints.resize(joints);
  for (std::string& name : robot.joints) in >> name;
  robot.states.resize(states);
  for (State& state : robot.states) {
    state.q.resize(positions);
    state.v.resize(robot.size);
    state.a.resize(robot.size);
    for (Numbers* values : {&state.q, &state.v, &state.a})
      for (double& value : *values) in >> value;
  }
  return robot;
}

/// Value at row i, column j of matrix m, in Pinocchio's order. Of symmetric matrices the upper half.
double value(const Implementation& of, const Numbers& result, std::size_t size, std::size_t m, std::size_t i,
             std::size_t j) {
  return result[(m * size + of.place[j]) * size + of.place[i]];
}

double difference(const Robot& robot, std::size_t function, const Implementation& one,
                  const Implementation& other) {
  const std::size_t n = robot.size;
  const bool symmetric = function == 1;
  double largest = 0, scale = 1;
  const auto compare = [&](double a, double b) {
    scale = std::max(scale, std::abs(b));
    largest = std::max(largest, std::isfinite(a) ? std::abs(a - b) : INFINITY);
  };
  for (std::size_t k = 0; k < robot.states.size(); ++k) {
    Numbers a(3 * n * n), b(3 * n * n);
    one.calls[function](k);
    one.copies[function](a.data());
    other.calls[function](k);
    other.copies[function](b.data());
    if (matrices[function] == 0)
      for (std::size_t i = 0; i < n; ++i) compare(a[one.place[i]], b[other.place[i]]);
    for (std::size_t m = 0; m < matrices[function]; ++m)
      for (std::size_t j = 0; j < n; ++j)
        // M, and its inverse, are symmetric: Pinocchio fills the upper half.
        for (std::size_t i = 0; i < (symmetric || m == 2 ? j + 1 : n); ++i)
          compare(value(one, a, n, m, i, j), value(other, b, n, m, i, j));
  }
  return largest / scale;
}

/// The fastest of several goes over all states, in nanoseconds a call.
double nanoseconds(const Robot& robot, Call call) {
  double best = INFINITY;
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(300);
  while (Clock::now() < until) {
    const auto start = Clock::now();
    for (std::size_t k = 0; k < robot.states.size(); ++k) call(k);
    const std::chrono::duration<double, std::nano> took = Clock::now() - start;
    best = std::min(best, took.count() / static_cast<double>(robot.states.size()));
  }
  return best;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 64;
  const Robot robot = read(arguments[1]);
  std::vector<Implementation> all{of_qvgen(robot), of_casadi(robot)};
#if QVGEN_WITH_LOOPS
  all.push_back(of_pinocchio(robot, arguments[2]));
#endif
  for (std::size_t f = 0; f < functions; ++f) {
    if (count == 6) {
      const Implementation& one = all[static_cast<std::size_t>(std::atoi(arguments[3]))];
      if (arguments[4] != std::string(function_names[f])) continue;
      const auto calls = static_cast<std::size_t>(std::atoi(arguments[5]));
      for (std::size_t k = 0; k < calls; ++k) one.calls[f](k % robot.states.size());
      continue;
    }
    std::printf("%s", function_names[f]);
    for (const Implementation& one : all) std::printf(" %.1f", nanoseconds(robot, one.calls[f]));
    for (std::size_t k = 1; k < all.size(); ++k) std::printf(" %.2g", difference(robot, f, all[0], all[k]));
    std::printf("\n");
  }
  return 0;
}
