// SPDX-License-Identifier: MIT
// 200 random linkages of each family, by the geometry of one mechanism each: the number of assemblies is what
// circles and lines say that meet, and every one closes. Boundary cases by name.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/delta/assembly.h>
#include <qvgen/robots/five_bar_family/assembly.h>
#include <qvgen/robots/four_bar/assembly.h>
#include <qvgen/robots/slider_crank_family/assembly.h>

namespace qvgen::test::loops {
namespace {

namespace four_bar = qvgen::robots::four_bar;
namespace five_bar = qvgen::robots::five_bar_family;
namespace slider = qvgen::robots::slider_crank_family;
namespace delta = qvgen::robots::delta;

constexpr int linkages = 200, inputs = QVGEN_LOOP_INPUTS < 1000 ? 20 : QVGEN_LOOP_INPUTS;

four_bar::Geometry four_bar_of(double crank, double coupler, double rocker, double ground) {
  four_bar::Geometry g;
  g.r1 = crank;
  g.r2 = coupler;
  g.r3 = rocker;
  g.ground = ground;
  return g;
}

delta::Geometry delta_of(double base, double upper, double lower, double platform) {
  delta::Geometry g;
  g.base = base;
  g.upper = upper;
  g.lower = lower;
  g.platform = platform;
  return g;
}

using Point = Eigen::Vector2d;
Point on_circle(double radius, double angle) { return radius * Point(std::cos(angle), std::sin(angle)); }

/// How many points two circles share, -1 where rounding would decide.
int meetings(double distance, double a, double b) {
  const double inner = distance - std::abs(a - b), outer = a + b - distance;
  if (std::abs(inner) < 1e-9 || std::abs(outer) < 1e-9) return -1;
  return inner > 0 && outer > 0 ? 2 : 0;
}

class Families : public testing::Test {
 protected:
  double length() { return std::uniform_real_distribution<double>(0.05, 1)(random_); }
  double angle() { return std::uniform_real_distribution<double>(-7, 7)(random_); }
  std::mt19937 random_{17};
};

TEST_F(Families, FourBars) {
  int solved = 0;
  for (int k = 0; k < linkages; ++k) {
    const four_bar::Geometry g = four_bar_of(length(), length(), length(), length());
    for (int i = 0; i < inputs; ++i) {
      const double a = angle();
      const int expected = meetings((on_circle(g.r1, a) - Point(g.ground, 0)).norm(), g.r2, g.r3);
      if (expected < 0) continue;
      const auto found = four_bar::assemble(four_bar::Driven(a), g);
      ASSERT_EQ(found.size(), expected);
      ASSERT_EQ(found.status, expected == 0 ? Status::unreachable : Status::solved);
      for (const auto& row : found) {
        const Point elbow = on_circle(g.r1, row.q[0]) + on_circle(g.r2, row.q[0] + row.q[1]);
        const Point rocker = Point(g.ground, 0) + on_circle(g.r3, row.q[2]);
        ASSERT_LT((elbow - rocker).norm(), 1e-13 * (g.r1 + g.r2 + g.r3 + g.ground));
        ++solved;
      }
    }
  }
  EXPECT_GT(solved, linkages);
}

TEST_F(Families, SliderCranks) {
  int solved = 0;
  for (int k = 0; k < linkages; ++k) {
    slider::Geometry g;
    g.r1 = length();
    g.r2 = length();
    g.offset = length() - 0.5;
    for (int i = 0; i < inputs; ++i) {
      const double a = angle();
      const double height = g.offset - g.r1 * std::sin(a);
      if (std::abs(std::abs(height) - g.r2) < 1e-9) continue;
      const auto found = slider::assemble(slider::Driven(a), g);
      ASSERT_EQ(found.size(), std::abs(height) < g.r2 ? 2 : 0);
      for (const auto& row : found) {
        const Point end = on_circle(g.r1, row.q[0]) + on_circle(g.r2, row.q[0] + row.q[1]);
        ASSERT_LT((end - Point(row.q[2], g.offset)).norm(), 1e-13 * (g.r1 + g.r2 + std::abs(g.offset)));
        ++solved;
      }
    }
  }
  EXPECT_GT(solved, linkages);
}

TEST_F(Families, FiveBars) {
  int solved = 0;
  for (int k = 0; k < linkages; ++k) {
    five_bar::Geometry g;
    for (double* field : {&g.l1, &g.l2, &g.l3, &g.l4, &g.base}) *field = length();
    for (int i = 0; i < inputs; ++i) {
      const five_bar::Driven a(angle(), angle());
      const Point left = on_circle(g.l1, a[0]), right = Point(g.base, 0) + on_circle(g.l3, a[1]);
      const int expected = meetings((left - right).norm(), g.l2, g.l4);
      if (expected < 0) continue;
      const auto found = five_bar::assemble(a, g);
      ASSERT_EQ(found.size(), expected);
      for (const auto& row : found) {
        const Point one = left + on_circle(g.l2, row.q[0] + row.q[1]);
        const Point other = right + on_circle(g.l4, row.q[2] + row.q[3]);
        ASSERT_LT((one - other).norm(), 1e-13 * (g.l1 + g.l2 + g.l3 + g.l4 + g.base));
        ++solved;
      }
    }
  }
  EXPECT_GT(solved, linkages);
}

/// Ends of a delta's rods.
Eigen::Vector3d direction(int arm, double forward, double up) {
  const double turn = 2 * M_PI / 3 * arm;
  return {forward * std::cos(turn), forward * std::sin(turn), up};
}

TEST_F(Families, Deltas) {
  int forward = 0, inverse = 0;
  for (int k = 0; k < linkages; ++k) {
    const delta::Geometry g = delta_of(length(), length(), length() + 0.3, length() / 2);
    for (int i = 0; i < inputs; ++i) {
      const Eigen::Vector3d a(angle(), angle(), angle());
      const auto gap = [&](const delta::JointVector<double>& q) {
        double worst = 0;
        for (int arm = 0; arm < 3; ++arm) {
          const Eigen::Vector3d elbow =
              direction(arm, g.base + g.upper * std::cos(q[arm]), -g.upper * std::sin(q[arm]));
          const Eigen::Vector3d end = q.tail<3>() + direction(arm, g.platform, 0);
          worst = std::max(worst, std::abs((elbow - end).norm() - g.lower));
        }
        return worst;
      };
      const double size = g.base + g.upper + g.lower + g.platform;
      const auto found = delta::assemble(a, g);
      for (const auto& row : found) {
        ASSERT_LT(gap(row.q), 1e-13 * size);
        ++forward;
        const auto modes = delta::assemble_from_outputs(row.q.tail<3>(), g);
        bool same = false;
        for (const auto& mode : modes) {
          ASSERT_LT(gap(mode.q), 1e-13 * size);
          double off = 0;
          for (int arm = 0; arm < 3; ++arm)
            off = std::max(off, std::abs(std::sin((mode.q[arm] - a[arm]) / 2)));
          same = same || off < 1e-6;
          ++inverse;
        }
        ASSERT_TRUE(same) << "the arms that led there are not among the working modes";
      }
    }
  }
  EXPECT_GT(forward, linkages);
  EXPECT_GT(inverse, forward);
}

TEST_F(Families, LengthsThatCannotBeAssembledAreUnreachableForAllAngles) {
  const four_bar::Geometry g = four_bar_of(0.1, 0.2, 0.15, 1);
  for (double a = -4; a < 4; a += 0.01) {
    const auto found = four_bar::assemble(four_bar::Driven(a), g);
    EXPECT_EQ(found.status, Status::unreachable);
    EXPECT_TRUE(found.empty());
  }
}

TEST_F(Families, AtADeadCentreTwoAssembliesAreOneThatIsMarked) {
  // Coupler and rocker in line, stretched and folded: 3/4 is 1/2 + 1/4, and 1/4 is 1/2 - 1/4.
  for (const double ground : {1.0, 0.5}) {
    const four_bar::Geometry g = four_bar_of(0.25, 0.5, 0.25, ground);
    const auto found = four_bar::assemble(four_bar::Driven(0.0), g);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found.status, Status::solved);
    EXPECT_TRUE(found.meets(found[0]));
    EXPECT_LT(four_bar::loop_gaps(found[0].q, g).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT(four_bar::drive_measure(found[0].q, g), 1e-9);
  }
  // Beyond by a millionth there is none, within there are two.
  EXPECT_TRUE(four_bar::assemble(four_bar::Driven(0.0), four_bar_of(0.25, 0.5, 0.25, 1.000001)).empty());
  EXPECT_EQ(four_bar::assemble(four_bar::Driven(0.0), four_bar_of(0.25, 0.5, 0.25, 0.999999)).size(), 2);
}

TEST_F(Families, LimitsLeaveTheAssembliesThatAreWithin) {
  const auto found = four_bar::assemble(four_bar::Driven(0.8));
  ASSERT_EQ(found.size(), 2);
  for (const auto& row : found) {
    // A window around this row's passive joints, two turns further.
    qvgen::JointLimits<3> limits;
    limits.lower = row.q.array() - 0.01;
    limits.upper = row.q.array() + 0.01;
    limits.lower[2] += 4 * M_PI;
    limits.upper[2] += 4 * M_PI;
    const auto within = qvgen::within_limits(found, limits, four_bar::is_revolute);
    ASSERT_EQ(within.size(), 1);
    for (const auto& left : within) {
      EXPECT_EQ(left.branch, row.branch);
      EXPECT_NEAR(left.q[2], row.q[2] + 4 * M_PI, 1e-12);
    }
  }
}

TEST_F(Families, AFoldingParallelogramMeetsItsMirrorImage) {
  const four_bar::Geometry g = four_bar_of(0.3, 1, 0.3, 1);
  const auto open = four_bar::assemble(four_bar::Driven(0.7), g);
  ASSERT_EQ(open.size(), 2);
  for (const auto& row : open) EXPECT_FALSE(open.meets(row));
  for (const double a : {0.0, M_PI}) {
    const auto folded = four_bar::assemble(four_bar::Driven(a), g);
    ASSERT_EQ(folded.size(), 1);
    EXPECT_TRUE(folded.meets(folded[0]));
    EXPECT_LT(four_bar::loop_gaps(folded[0].q, g).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST_F(Families, AKiteWithItsPivotsInOnePointIsAContinuum) {
  // The crank as long as the ground: its end comes to the rocker's pivot, and the rocker is free.
  const four_bar::Geometry g = four_bar_of(1, 0.5, 0.5, 1);
  const auto found = four_bar::assemble(four_bar::Driven(0.0), g);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.status, Status::singular);
  for (const auto& row : found) {
    EXPECT_TRUE(row.continuum);
    EXPECT_LT(four_bar::loop_gaps(row.q, g).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST_F(Families, ADeltaWithItsCentresInLineSaysSo) {
  // All arms to the middle: no radius is left, and the three spheres have one centre; their rods are equal.
  const delta::Geometry g = delta_of(0.2, 0.1, 0.8, 0.1);
  const auto found = delta::assemble(Eigen::Vector3d(M_PI, M_PI, M_PI), g);
  EXPECT_TRUE(found.status == Status::incomplete || found.status == Status::singular ||
              found.status == Status::unreachable || !found.empty());
  for (const auto& row : found) EXPECT_LT(delta::loop_gaps(row.q, g).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace qvgen::test::loops
