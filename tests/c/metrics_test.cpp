// SPDX-License-Identifier: MIT
// Orders of solutions in C against those of C++, of random rows: the same order, and the same values to
// rounding.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/metrics.h>
#include <qvgen/robots/puma560/model.h>

#include "qvgen_puma560_metrics.h"

namespace {

namespace arm = qvgen::robots::puma560;
using Joints = qvgen::Joints<6>;
constexpr int capacity = puma560_solutions_capacity;

/// A set of rows in both languages.
template <class Found>
struct Both {
  Found cxx;
  puma560_solutions c{};

  explicit Both(std::mt19937& random) {
    std::uniform_real_distribution<double> angle(-9, 9);
    const int count = static_cast<int>(random() % (capacity + 1));
    for (int k = 0; k < count; ++k) {
      const Joints q = Joints::NullaryExpr([&] { return angle(random); });
      qvgen::inverse::append(cxx, q, k, false);
      puma560_solution& row = c.rows[c.count++];
      std::copy(q.begin(), q.end(), row.q);
      row.branch = k;
    }
    cxx.conclude();
  }
  void expect_same_order() const {
    ASSERT_EQ(c.count, cxx.size());
    for (int k = 0; k < c.count; ++k) {
      ASSERT_EQ(c.rows[k].branch, cxx[k].branch);
      for (int i = 0; i < 6; ++i) ASSERT_EQ(c.rows[k].q[i], cxx[k].q[i]);
    }
  }
};

template <class Found, class Metric>
void expect_the_order_of_cxx(int within_limits, puma560_metric in_c, const void* constants,
                             const Metric& metric) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-9, 9);
  for (int i = 0; i < 300; ++i) {
    Both<Found> both(random);
    const Joints seed = Joints::NullaryExpr([&] { return angle(random); });
    const Joints way = Joints::NullaryExpr([&] { return angle(random); });
    ASSERT_NEAR(in_c(way.data(), constants), metric(way), 1e-14 * metric(way));
    const puma560_solution* best = puma560_best_by(&both.c, seed.data(), within_limits, in_c, constants);
    const qvgen::Solution<6>* nearest = qvgen::nearest(both.cxx, seed, arm::is_revolute, metric);
    ASSERT_EQ(best == nullptr, nearest == nullptr);
    if (best != nullptr) {
      ASSERT_EQ(best->branch, nearest->branch);
    }
    qvgen::sort_by(both.cxx, seed, arm::is_revolute, metric);
    puma560_sort_by(&both.c, seed.data(), within_limits, in_c, constants);
    ASSERT_NO_FATAL_FAILURE(both.expect_same_order());
  }
}

template <class Metric>
void expect_both_orders_of_cxx(puma560_metric in_c, const void* constants, const Metric& metric) {
  expect_the_order_of_cxx<qvgen::Solutions<6, capacity>>(0, in_c, constants, metric);
  expect_the_order_of_cxx<qvgen::LimitedSolutions<6, capacity>>(1, in_c, constants, metric);
}

TEST(MetricsInC, HaveTheOrderOfCxx) {
  const double weights[6] = {1, 2, 3, 0.5, 0.25, 4};
  const Joints same(weights);
  expect_both_orders_of_cxx(puma560_weighted_distance, weights, qvgen::WeightedDistance<6>{same});
  expect_both_orders_of_cxx(puma560_largest_joint, weights, qvgen::LargestJoint<6>{same});
  expect_both_orders_of_cxx(puma560_largest_joint, nullptr, qvgen::LargestJoint<6>{});
  puma560_drives drives = {{1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1}};
  expect_both_orders_of_cxx(puma560_fastest_time, &drives,
                            qvgen::FastestTime<6>{Joints(drives.speeds), Joints(drives.accelerations)});
  for (double& each : drives.accelerations) each = std::numeric_limits<double>::infinity();
  expect_both_orders_of_cxx(puma560_fastest_time, &drives,
                            qvgen::FastestTime<6>{Joints(drives.speeds), Joints(drives.accelerations)});
}

extern "C" double lowest_second_joint(const double q[6], const void* bound) {
  return q[1] < *static_cast<const double*>(bound) ? std::numeric_limits<double>::quiet_NaN() : q[1];
}

TEST(MetricsInC, AScoreOfOnesOwn) {
  std::mt19937 random(6);
  const double bound = -3;
  for (int i = 0; i < 300; ++i) {
    Both<qvgen::Solutions<6, capacity>> both(random);
    const auto score = [&](const Joints& q) { return lowest_second_joint(q.data(), &bound); };
    const qvgen::Solution<6>* expected = qvgen::best(both.cxx, score);
    const puma560_solution* best = puma560_best_by(&both.c, nullptr, 0, lowest_second_joint, &bound);
    ASSERT_EQ(best == nullptr, expected == nullptr);
    if (best != nullptr) {
      ASSERT_EQ(best->branch, expected->branch);
    }
    qvgen::sort_by(both.cxx, score);
    puma560_sort_by(&both.c, nullptr, 0, lowest_second_joint, &bound);
    ASSERT_NO_FATAL_FAILURE(both.expect_same_order());
  }
}

}  // namespace
