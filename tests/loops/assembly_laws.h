// SPDX-License-Identifier: MIT
// Laws of sets of assemblies: every row closes all loops, none is there twice, and none of those is missing
// that Newton's steps find from many starts.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism_under_test.h"
#include "reference/loops.h"

namespace qvgen::test::loops {

inline double wrapped(double angle) { return std::remainder(angle, 2 * M_PI); }

inline double distance(const reference::LoopMechanism& of, const VectorXd& a, const VectorXd& b) {
  double worst = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const bool turns = of.chain.joints[static_cast<std::size_t>(i)].revolute;
    worst = std::max(worst, std::abs(turns ? wrapped(a[i] - b[i]) : a[i] - b[i]));
  }
  return worst;
}

inline bool has(const reference::LoopMechanism& of, const Set& set, const VectorXd& q, double within) {
  return std::any_of(set.rows.begin(), set.rows.end(),
                     [&](const Row& row) { return distance(of, row.q, q) < within; });
}

/// Values for some joints: any, slides within the mechanism's size; or, in every second case, those of an
/// assembly.
inline VectorXd random_values(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& joints,
                              std::mt19937& random) {
  std::uniform_real_distribution<double> turn(-3.2, 3.2), slide(-of.size / 2, of.size / 2);
  const auto count = static_cast<Eigen::Index>(of.chain.joints.size());
  const auto assembled = random() % 2 == 0 ? reference::assemblies(of, VectorXd::Zero(count), {}, 1,
                                                                   static_cast<unsigned>(random()))
                                           : std::vector<VectorXd>{};
  VectorXd values(static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::Index joint = joints[static_cast<std::size_t>(i)];
    const bool turns = of.chain.joints[static_cast<std::size_t>(joint)].revolute;
    values[i] = !assembled.empty() ? assembled[0][joint] : turns ? turn(random) : slide(random);
  }
  return values;
}

inline VectorXd with_values(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& joints,
                            const VectorXd& values) {
  VectorXd q = VectorXd::Zero(static_cast<Eigen::Index>(of.chain.joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) q[joints[i]] = values[static_cast<Eigen::Index>(i)];
  return q;
}

inline void expect_closed(const reference::LoopMechanism& of, const Set& set) {
  for (const Row& row : set.rows) {
    EXPECT_LT(reference::gaps(of, row.q).cwiseAbs().maxCoeff(), 1e-13 * of.size);
    for (const Row& other : set.rows)
      if (&other != &row) {
        EXPECT_GT(distance(of, row.q, other.q), 1e-9) << "an assembly is there twice";
      }
  }
}

/// Two assemblies that meet are hard for Newton's steps, and not counted.
inline bool is_apart(const reference::LoopMechanism& of, const Set& set) {
  for (const Row& row : set.rows)
    for (const Row& other : set.rows)
      if (row.meets || (&row != &other && distance(of, row.q, other.q) < 1e-3)) return false;
  return true;
}

/// How many inputs are tried, from how many starts Newton's steps look for assemblies at one of so many of
/// them.
struct Effort {
  int inputs, starts, every = 1;
};

/// Inputs at which the rows are those that Newton's steps find from many starts. Returns how many assemblies
/// there were.
inline int compare(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& given,
                   const std::function<Set(const VectorXd&)>& solve, const Effort& effort,
                   std::mt19937& random) {
  int assemblies = 0;
  for (int k = 0; k < effort.inputs; ++k) {
    const VectorXd values = random_values(of, given, random);
    const VectorXd q = with_values(of, given, values);
    const Set set = solve(values);
    expect_closed(of, set);
    EXPECT_EQ(set.status, set.rows.empty() ? Status::unreachable : Status::solved);
    assemblies += static_cast<int>(set.rows.size());
    if (k % effort.every != 0 || !is_apart(of, set)) continue;
    for (const VectorXd& other : reference::assemblies(of, q, given, effort.starts, static_cast<unsigned>(k)))
      EXPECT_TRUE(has(of, set, other, 1e-6))
          << "missing: " << other.transpose() << " for " << values.transpose();
  }
  return assemblies;
}

}  // namespace qvgen::test::loops
