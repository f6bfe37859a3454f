// SPDX-License-Identifier: MIT
// Rates and accelerations from positions: exact for polynomials, at uneven times too, and never across a gap.
#include "identify/derivatives.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

using Eigen::Index;
using identify::MotionLog;

/// q = t^4 - 2 t^3 + t at these times, one joint.
MotionLog quartic(const std::vector<double>& time) {
  MotionLog log{"", time, Eigen::MatrixXd(static_cast<Index>(time.size()), 1), {}, {}, {}};
  for (std::size_t k = 0; k < time.size(); ++k)
    log.q(static_cast<Index>(k), 0) = std::pow(time[k], 4) - 2 * std::pow(time[k], 3) + time[k];
  return log;
}

void expect_exact(const MotionLog& log, Index first, Index end) {
  for (Index k = first; k < end; ++k) {
    const double t = log.time[static_cast<std::size_t>(k)];
    EXPECT_NEAR(log.qd(k, 0), 4 * t * t * t - 6 * t * t + 1, 1e-9) << k;
    EXPECT_NEAR(log.qdd(k, 0), 12 * t * t - 12 * t, 1e-7) << k;
  }
}

TEST(Derivatives, QuarticsAreExact) {
  std::vector<double> time;
  for (int k = 0; k < 200; ++k) time.push_back(0.01 * k);
  MotionLog log = quartic(time);
  derive_motion(log, 5);
  expect_exact(log, 5, 195);
  for (const Index k : {0, 4, 195, 199})
    EXPECT_TRUE(std::isnan(log.qd(k, 0)) && std::isnan(log.qdd(k, 0))) << k;
}

TEST(Derivatives, UnevenTimesAreExactToo) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(0.006, 0.014);
  std::vector<double> time{0};
  for (int k = 1; k < 200; ++k) time.push_back(time.back() + step(random));
  MotionLog log = quartic(time);
  derive_motion(log, 4);
  expect_exact(log, 4, 196);
}

/// Numbers that no polynomial has: Eigen's decomposition finds the same nearest quartic.
TEST(Derivatives, UnevenTimesGiveTheNearestQuartic) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> step(0.0005, 0.0015), number(-1, 1);
  MotionLog log{"", {0}, Eigen::MatrixXd(300, 2), {}, {}, {}};
  for (int k = 1; k < 300; ++k) log.time.push_back(log.time.back() + step(random));
  for (double& each : log.q.reshaped()) each = number(random);
  for (const Index half : {3, 16, 128}) {
    MotionLog found = log;
    derive_motion(found, half);
    for (Index k = half; k < 300 - half; k += 7) {
      const Eigen::VectorXd time = Eigen::VectorXd::Map(log.time.data() + k - half, 2 * half + 1).array() -
                                   log.time[static_cast<std::size_t>(k)];
      const double unit = time.maxCoeff();
      Eigen::MatrixXd powers(time.size(), 5);
      for (Index power = 0; power < 5; ++power)
        powers.col(power) = (time / unit).array().pow(static_cast<double>(power));
      Eigen::MatrixXd fit(5, log.q.cols());
      for (Index joint = 0; joint < fit.cols(); ++joint)
        fit.col(joint) = reference::least_squares(powers, log.q.col(joint).segment(k - half, 2 * half + 1));
      EXPECT_LT((found.q.row(k) - fit.row(0)).norm(), 1e-12);
      EXPECT_LT((found.qd.row(k) * unit - fit.row(1)).norm(), 1e-11);
      EXPECT_LT((found.qdd.row(k) * unit * unit / 2 - fit.row(2)).norm(), 1e-11);
    }
  }
}

/// With a stride some samples get the same numbers as without, and the others none.
TEST(Derivatives, AStrideLeavesSamplesOut) {
  std::vector<double> time;
  for (int k = 0; k < 60; ++k) time.push_back(0.01 * k);
  MotionLog all = quartic(time), some = all;
  derive_motion(all, 4);
  derive_motion(some, 4, 3);
  for (Index k = 4; k < 56; ++k) {
    if (k % 3 == 0)
      EXPECT_EQ(some.qdd(k, 0), all.qdd(k, 0));
    else
      EXPECT_TRUE(std::isnan(some.qdd(k, 0)));
  }
}

TEST(Derivatives, NothingIsFittedAcrossAGap) {
  std::vector<double> time;
  for (int k = 0; k < 100; ++k) time.push_back(0.01 * k + (k < 50 ? 0 : 1));
  EXPECT_EQ(identify::pieces_of(time), (std::vector<std::pair<Index, Index>>{{0, 50}, {50, 100}}));
  MotionLog log = quartic(time);
  derive_motion(log, 3);
  for (const Index k : {47, 49, 50, 52}) EXPECT_TRUE(std::isnan(log.qd(k, 0))) << k;
  expect_exact(log, 3, 47);
  expect_exact(log, 53, 97);
}

TEST(Derivatives, MeasuredRatesAreKept) {
  std::vector<double> time;
  for (int k = 0; k < 60; ++k) time.push_back(0.01 * k);
  MotionLog log = quartic(time);
  log.qd = log.q;  // any numbers
  derive_motion(log, 3);
  EXPECT_EQ(log.qd, log.q);
  for (Index k = 3; k < 57; ++k) {
    const double t = log.time[static_cast<std::size_t>(k)];
    EXPECT_NEAR(log.qdd(k, 0), 4 * t * t * t - 6 * t * t + 1, 1e-9);
  }
}

/// A sine at the band has half of its acceleration's power left, and no phase.
TEST(Derivatives, TheBandHalvesThePower) {
  constexpr double step = 0.002;
  for (const Index half : {4, 11, 32}) {
    const double w = 2 * std::numbers::pi * identify::band_of(half, step);
    MotionLog log{"", {}, Eigen::MatrixXd(2001, 1), {}, {}, {}};
    for (Index k = 0; k < 2001; ++k) {
      log.time.push_back(step * static_cast<double>(k));
      log.q(k, 0) = std::sin(w * log.time.back());
    }
    derive_motion(log, half);
    for (Index k = half; k < 2001 - half; ++k)
      EXPECT_NEAR(log.qdd(k, 0) / (w * w),
                  -std::sqrt(0.5) * std::sin(w * log.time[static_cast<std::size_t>(k)]), 5e-3);
  }
}

}  // namespace
}  // namespace qvgen::test
