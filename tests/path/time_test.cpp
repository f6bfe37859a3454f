// SPDX-License-Identifier: MIT
// Timing: one joint takes the time of a trapezoid; on random ways no limit is left anywhere, some limit holds
// the motion back everywhere, and odd input gets an answer.
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/path/time.h>

namespace path_test {
namespace {

using namespace qvgen;
using namespace qvgen::path;

template <int dof>
struct Timed {
  std::vector<Joints<dof>> q;
  std::vector<typename Timing<dof>::Point> points;
  Timing<dof> timing;
  double seconds;

  Timed(std::vector<Joints<dof>> joints, const path::RateLimits<dof>& limits)
      : q(std::move(joints)),
        points(q.size()),
        timing(q.data(), q.size(), limits, points.data()),
        seconds(timing.run()) {}
  Timed(const Timed&) = delete;
};

/// From rest to rest over a length.
double trapezoid(double length, double speed, double acceleration) {
  const double ramp = speed * speed / acceleration;
  return length > ramp ? speed / acceleration + length / speed : 2 * std::sqrt(length / acceleration);
}

TEST(PathTiming, AStraightWayTakesTheTimeOfATrapezoid) {
  for (const double length : {0.3, 5.0})
    for (const std::size_t count : {400U, 2000U}) {
      std::vector<Joints<2>> q;
      for (std::size_t i = 0; i < count; ++i)
        q.push_back(Joints<2>(1, -2) * (length * static_cast<double>(i) / static_cast<double>(count - 1)));
      const path::RateLimits<2> limits{{3, 1.5}, {8, 4}};  // the second joint is the slower one
      const Timed<2> timed(q, limits);
      const double exact = trapezoid(2 * length, 1.5, 4);
      EXPECT_GE(timed.seconds, exact * (1 - 1e-9));
      EXPECT_LT(timed.seconds, exact * (1 + 2.0 / static_cast<double>(count)));
    }
}

/// On a circle the centripetal acceleration bounds the speed: r a for two joints with the same limits.
TEST(PathTiming, OnACircleTheSpeedIsThatOfItsBend) {
  std::vector<Joints<2>> q;
  const double radius = 0.5, turns = 6 * 3.14159265358979323846;
  for (int i = 0; i <= 3000; ++i)
    q.emplace_back(radius * std::cos(turns * i / 3000), radius * std::sin(turns * i / 3000));
  const path::RateLimits<2> limits{{100, 100}, {2, 2}};
  const Timed<2> timed(q, limits);
  // |q''| w = w / r <= a where a joint turns back; between, both limits together allow more, sqrt 2 at most.
  const double slowest = radius * turns / std::sqrt(2 * radius);
  EXPECT_LT(timed.seconds, slowest + 2);
  EXPECT_GT(timed.seconds, slowest / std::sqrt(std::sqrt(2.0)));
}

template <int dof>
std::vector<Joints<dof>> random_way(std::mt19937& random, int count) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Joints<dof>(Joints<dof>::NullaryExpr([&] { return normal(random); })); };
  const Joints<dof> a = vector(), b = vector(), c = vector(), d = vector();
  std::vector<Joints<dof>> q;
  for (int i = 0; i < count; ++i) {
    const double t = 6.0 * i / (count - 1);
    q.push_back(a * std::sin(t) + b * std::cos(1.7 * t) + c * std::sin(2.9 * t) + 0.3 * t * d);
  }
  return q;
}

TEST(PathTiming, NoLimitIsLeftAndSomeLimitHolds) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    std::uniform_real_distribution<double> limit(0.5, 5);
    path::RateLimits<3> limits;
    for (int k = 0; k < 3; ++k) {
      limits.speed[k] = limit(random);
      limits.acceleration[k] = 4 * limit(random);
    }
    const Timed<3> timed(random_way<3>(random, 1000), limits);
    ASSERT_GT(timed.seconds, 0);
    int slack = 0;
    for (std::size_t i = 0; i + 1 < timed.q.size(); ++i) {
      double highest = 0;
      for (int k = 0; k <= 20; ++k) {
        Joints<3> speed, acceleration;
        timed.timing.rates(i, k / 20.0, speed, acceleration);
        const double ratio = std::max(speed.cwiseQuotient(limits.speed).cwiseAbs().maxCoeff(),
                                      acceleration.cwiseQuotient(limits.acceleration).cwiseAbs().maxCoeff());
        ASSERT_LE(ratio, 1 + 1e-9) << i;
        highest = std::max(highest, ratio);
      }
      slack += static_cast<int>(highest < 0.95);
    }
    EXPECT_LT(slack, 50);  // of 999
    EXPECT_EQ(timed.points.back().time, timed.seconds);
    EXPECT_LT(timed.points.back().w, 1e-9);
  }
}

/// Speeds and accelerations are those of the joints, by differences in time.
TEST(PathTiming, RatesAreTheDerivativesOfTheJoints) {
  std::mt19937 random(9);
  const path::RateLimits<3> limits{{2, 2, 2}, {9, 9, 9}};
  const Timed<3> timed(random_way<3>(random, 60), limits);
  for (std::size_t i = 0; i + 1 < 60; ++i) {
    const double step = 1e-4;
    Joints<3> speed, acceleration, before, after, ignored;
    timed.timing.rates(i, 0.5, speed, acceleration);
    timed.timing.rates(i, 0.5 - step, before, ignored);
    timed.timing.rates(i, 0.5 + step, after, ignored);
    const double w = timed.points[i].w + timed.points[i].u * timed.points[i].length;
    const double time = 2 * step * timed.points[i].length / std::sqrt(w);
    const Joints<3> way = timed.timing.joints(i, 0.5 + step) - timed.timing.joints(i, 0.5 - step);
    EXPECT_LT((way / time - speed).norm(), 1e-5);
    EXPECT_LT(((after - before) / time - acceleration).norm(), 1e-4);
    EXPECT_LT((timed.timing.joints(i, 1) - timed.q[i + 1]).norm(), 1e-12);
  }
}

TEST(PathTiming, OddInputGetsAnAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Joints<2> a(0, 0), b(1, 0.5), bad(nan, 0);
  const path::RateLimits<2> limits{{1, 1}, {1, 1}};
  EXPECT_EQ(Timed<2>({}, limits).seconds, 0);
  EXPECT_EQ(Timed<2>({a}, limits).seconds, 0);
  EXPECT_EQ(Timed<2>({a, a, a}, limits).seconds, 0);
  EXPECT_EQ(Timed<2>({a, b}, limits).seconds, inf);  // a point between is needed
  EXPECT_NEAR(Timed<2>({a, a, 0.5 * b, b, b}, limits).seconds, Timed<2>({a, 0.5 * b, b}, limits).seconds,
              1e-9);
  EXPECT_TRUE(std::isnan(Timed<2>({a, bad}, limits).seconds));
  EXPECT_TRUE(std::isnan(Timed<2>({a, b}, {{1, 0}, {1, 1}}).seconds));
  EXPECT_TRUE(std::isnan(Timed<2>({a, b}, {{1, nan}, {1, 1}}).seconds));
  EXPECT_GT(Timed<2>({a, 0.5 * b, b}, {{inf, inf}, {1, 1}}).seconds, 1);
}

}  // namespace
}  // namespace path_test
