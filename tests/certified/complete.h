// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <tuple>

#include <gtest/gtest.h>
#include <qvgen/inverse/certified/certify.h>

namespace qvgen::test {

/// Largest difference, of angles the short way round.
template <int dof, class Kinds>
double distance(const Eigen::Matrix<double, dof, 1>& a, const Eigen::Matrix<double, dof, 1>& b,
                const Kinds& is_revolute) {
  double most = 0;
  for (int i = 0; i < dof; ++i) {
    const double way = a[i] - b[i];
    const bool turns = is_revolute[static_cast<std::size_t>(i)];
    most = std::max(most, std::abs(turns ? std::remainder(way, 2 * std::acos(-1.0)) : way));
  }
  return most;
}

/// Poses of an arm: some, or as many as the environment variable QVGEN_POSES says.
inline int pose_count() {
  const char* text = std::getenv("QVGEN_POSES");
  return text == nullptr ? 8 : std::atoi(text);
}

/// Poses are proven to have the solutions that are found and no other, the sampled joints among them. Random
/// ones and, every other time, some with a joint next to a right angle, where many arms are singular.
/// `certified`: of joints, the proven solutions of the pose that they reach.
template <class Kinds, class Certified>
void expect_complete(const Kinds& is_revolute, const Certified& certified) {
  constexpr int dof = static_cast<int>(std::tuple_size<Kinds>::value);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-3, 3);
  const int poses = pose_count();
  int complete = 0;
  for (int n = 0; n < poses; ++n) {
    Eigen::Matrix<double, dof, 1> q;
    for (double& each : q) each = value(random);
    if (n % 2 == 1) q[n % dof] = (n % 4 - 2) * std::acos(0.0) + 1e-3;
    const auto found = certified(q);
    if (!found.is_complete()) continue;
    ++complete;
    double nearest = 1;
    for (int i = 0; i < found.solutions.size(); ++i) {
      EXPECT_TRUE(found.rows[static_cast<std::size_t>(i)].proven);
      nearest = std::min(nearest, distance(found.solutions[i].q, q, is_revolute));
    }
    EXPECT_LT(nearest, 1e-9);
  }
  EXPECT_GE(complete, poses - std::max(1, poses / 20));
}

}  // namespace qvgen::test
