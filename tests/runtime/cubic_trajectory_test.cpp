// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <qvgen/cubic_trajectory.h>

namespace {

using qvgen::CubicTrajectory;
using qvgen::Status;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t points = 6;
using Trajectory = CubicTrajectory<double, points>;

class CubicTrajectories : public testing::Test {
 protected:
  std::mt19937_64 random{54};
  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Trajectory::Points numbers() {
    Trajectory::Points result;
    for (double& x : result) x = within(-2, 2);
    return result;
  }
  Trajectory::Points times() {
    Trajectory::Points result;
    double time = within(-1, 1);
    for (double& t : result) t = time += within(0.1, 2);
    return result;
  }
};

TEST_F(CubicTrajectories, ACubicHasItsEnds) {
  for (int i = 0; i < 100; ++i) {
    const double p = within(-3, 3), q = within(-3, 3), v = within(-3, 3), w = within(-3, 3),
                 T = within(0.1, 5);
    const auto cubic = qvgen::cubic_between(p, q, T, v, w);
    EXPECT_NEAR(cubic.at(0).position, p, 1e-14);
    EXPECT_NEAR(cubic.at(0).rate, v, 1e-14);
    EXPECT_NEAR(cubic.at(T).position, q, 1e-12);
    EXPECT_NEAR(cubic.at(T).rate, w, 1e-11);
    const double t = within(0, T), h = 1e-5;
    EXPECT_NEAR(cubic.at(t).rate, (cubic.at(t + h).position - cubic.at(t - h).position) / (2 * h), 1e-4);
    EXPECT_NEAR(cubic.at(t).acceleration, (cubic.at(t + h).rate - cubic.at(t - h).rate) / (2 * h), 1e-4);
  }
  EXPECT_TRUE(std::isnan(qvgen::cubic_between(0.0, 1.0, 0.0).at(0.5).position));
  EXPECT_TRUE(std::isnan(qvgen::cubic_between(0.0, 1.0, -1.0).at(0.5).position));
}

TEST_F(CubicTrajectories, GoesThroughItsPointsWithTheirRates) {
  const auto t = times(), p = numbers(), v = numbers();
  const Trajectory path = Trajectory::through(t, p, v);
  ASSERT_EQ(path.status(), Status::solved);
  for (std::size_t i = 0; i < points; ++i) {
    EXPECT_NEAR(path.at(t[i]).position, p[i], 1e-11);
    EXPECT_NEAR(path.at(t[i]).rate, v[i], 1e-10);
    EXPECT_NEAR(path.at(std::nextafter(t[i], t[0])).position, p[i], 1e-11);
  }
}

/// All conditions of a spline as one dense system in the coefficients of its segments.
Eigen::VectorXd coefficients(const Trajectory::Points& t, const Trajectory::Points& p, bool clamped,
                             double begin, double end) {
  constexpr int segments = points - 1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4 * segments, 4 * segments);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(4 * segments);
  const auto position = [](double h) { return Eigen::RowVector4d(1, h, h * h, h * h * h); };
  const auto rate = [](double h) { return Eigen::RowVector4d(0, 1, 2 * h, 3 * h * h); };
  const auto acceleration = [](double h) { return Eigen::RowVector4d(0, 0, 2, 6 * h); };
  int row = 0;
  for (int i = 0; i < segments; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double h = t[at + 1] - t[at];
    A.block<1, 4>(row, 4 * i) = position(0);
    b[row++] = p[at];
    A.block<1, 4>(row, 4 * i) = position(h);
    b[row++] = p[at + 1];
    if (i + 1 == segments) continue;
    A.block<1, 4>(row, 4 * i) = rate(h);
    A.block<1, 4>(row++, 4 * i + 4) = -rate(0);
    A.block<1, 4>(row, 4 * i) = acceleration(h);
    A.block<1, 4>(row++, 4 * i + 4) = -acceleration(0);
  }
  const double last = t[points - 1] - t[points - 2];
  A.block<1, 4>(row, 0) = clamped ? rate(0) : acceleration(0);
  b[row++] = begin;
  A.block<1, 4>(row, 4 * segments - 4) = clamped ? rate(last) : acceleration(last);
  b[row] = end;
  return A.fullPivLu().solve(b);
}

TEST_F(CubicTrajectories, SmoothIsTheSolutionOfAllConditionsAtOnce) {
  for (int i = 0; i < 100; ++i) {
    const auto t = times(), p = numbers();
    const double begin = within(-2, 2), end = within(-2, 2);
    const bool clamped = i % 2 == 0;
    using Condition = qvgen::EndCondition<double>;
    const auto kind = clamped ? Condition::Kind::rate : Condition::Kind::acceleration;
    const Trajectory path = Trajectory::smooth(t, p, {kind, begin}, {kind, end});
    const Eigen::VectorXd expected = coefficients(t, p, clamped, begin, end);
    for (std::size_t s = 0; s + 1 < points; ++s)
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(path.segment(s).c[c], expected[static_cast<Eigen::Index>(4 * s + c)],
                    1e-10 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_F(CubicTrajectories, NamedEnds) {
  const auto t = times(), p = numbers();
  const Trajectory free = Trajectory::smooth(t, p, qvgen::natural<double>(), qvgen::natural<double>());
  EXPECT_NEAR(free.at(t.front()).acceleration, 0, 1e-10);
  EXPECT_NEAR(free.at(t.back()).acceleration, 0, 1e-10);
  const Trajectory held = Trajectory::smooth(t, p, qvgen::natural<double>(), qvgen::clamped(1.5));
  EXPECT_NEAR(held.at(t.front()).acceleration, 0, 1e-10);
  EXPECT_NEAR(held.at(t.back()).rate, 1.5, 1e-10);
  const Trajectory still = Trajectory::smooth(t, p);
  EXPECT_NEAR(still.at(t.front()).rate, 0, 1e-14);
  EXPECT_NEAR(still.at(t.back()).rate, 0, 1e-10);
}

TEST_F(CubicTrajectories, TwoPointsAreOneCubic) {
  const auto path = CubicTrajectory<double, 2>::smooth({1, 3}, {5, 6});
  EXPECT_EQ(path.segment(0).c, qvgen::cubic_between(5.0, 6.0, 2.0).c);
}

TEST_F(CubicTrajectories, RestsOutsideAndAnswersWhatIsNoTrajectory) {
  const CubicTrajectory<double, 2> path = CubicTrajectory<double, 2>::smooth({1, 3}, {5, 6});
  EXPECT_EQ(path.at(0).position, 5);
  EXPECT_EQ(path.at(-infinity).rate, 0);
  EXPECT_NEAR(path.at(infinity).position, 6, 1e-14);
  EXPECT_EQ(path.at(4).acceleration, 0);
  EXPECT_TRUE(std::isnan(path.at(nan).position));
  for (const std::array<double, 2> bad : {std::array<double, 2>{1, 1}, {2, 1}, {nan, 1}, {0, infinity}}) {
    const auto wrong = CubicTrajectory<double, 2>::smooth(bad, {5, 6});
    EXPECT_EQ(wrong.status(), Status::invalid);
    EXPECT_TRUE(std::isnan(wrong.at(1).position));
  }
  EXPECT_EQ((CubicTrajectory<double, 2>::smooth({0, 1}, {nan, 0}).status()), Status::invalid);
  EXPECT_EQ((CubicTrajectory<double, 2>{}.status()), Status::invalid);
}

/// Printed with two decimals, cut or rounded.
bool shows(double printed, double value) { return std::abs(printed - value) < 0.011; }

// Example 5.4 prints for 0.92 s what cubics from 0 to 360 degrees, 20 and 18 in 3 s, at rest at both ends,
// have.
TEST_F(CubicTrajectories, TheLecturesExample54) {
  const std::array<double, 3> ends{360, 20, 18}, positions{80.80, 4.48, 4.04}, rates{153.08, 8.50, 7.65};
  for (std::size_t i = 0; i < 3; ++i) {
    const qvgen::Motion<double> motion = qvgen::cubic_between(0.0, ends[i], 3.0).at(0.92);
    EXPECT_TRUE(shows(positions[i], motion.position)) << motion.position;
    EXPECT_TRUE(shows(rates[i], motion.rate)) << motion.rate;
  }
}

/// When such a motion has a position, or (in its first half) a rate, in s; by bisection.
double time_of(double end, double value, bool is_rate) {
  const auto cubic = qvgen::cubic_between(0.0, end, 3.0);
  double low = 0, high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const auto motion = cubic.at(middle);
    ((is_rate ? motion.rate : motion.position) < value ? low : high) = middle;
  }
  return low;
}

// Example 5.5 says 0.78 s. Its positions are those of 0.768 s, its rates those of 0.98 s.
TEST_F(CubicTrajectories, TheLecturesExample55) {
  const std::array<double, 3> ends{360, 20, 18}, positions{58.7, 3.26, 2.93}, rates{158.6, 8.82, 7.9};
  for (std::size_t i = 0; i < 3; ++i) {
    const double of_position = time_of(ends[i], positions[i], false);
    const double of_rate = time_of(ends[i], rates[i], true);
    EXPECT_NEAR(of_position, 0.768, 0.001);
    EXPECT_NEAR(of_rate, 0.981, 0.006);
    const qvgen::Motion<double> as_said = qvgen::cubic_between(0.0, ends[i], 3.0).at(0.78);
    EXPECT_FALSE(shows(positions[i], as_said.position));
    EXPECT_FALSE(shows(rates[i], as_said.rate));
  }
}

}  // namespace
