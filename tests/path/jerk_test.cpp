// SPDX-License-Identifier: MIT
// Limits of joint jerk: a straight way takes the time of its closed form; on random ways no limit is left,
// the motion is continuous to its second derivative, and it is not much slower than without.
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/path/jerk.h>

namespace path_test {
namespace {

using namespace qvgen;
using path::Smoothing;
using path::Timing;

template <int dof>
struct Smooth {
  std::vector<Joints<dof>> q;
  path::RateLimits<dof> limits;
  std::vector<typename Timing<dof>::Point> points;
  std::vector<double> ways, integrals;
  Timing<dof> timing;
  double fastest;
  Smoothing<dof> smoothing;
  double seconds;

  Smooth(std::vector<Joints<dof>> way, const path::RateLimits<dof>& rates, const Joints<dof>& jerks)
      : q(std::move(way)),
        limits(rates),
        points(q.size()),
        ways(q.size()),
        integrals(q.size()),
        timing(q.data(), q.size(), rates, points.data()),
        fastest(timing.run()),
        smoothing(timing, points.data(), points.size(), rates, jerks, ways.data(), integrals.data()),
        seconds(smoothing.run(fastest)) {}
  Smooth(const Smooth&) = delete;

  /// Joints at a time.
  [[nodiscard]] Joints<dof> at(double time) const {
    const double s = smoothing.at(time).s;
    std::size_t i = 0;
    while (i + 2 < ways.size() && ways[i + 1] <= s) ++i;
    return timing.joints(i, (s - ways[i]) / points[i].length);
  }
};

TEST(PathJerk, AStraightWayTakesTheTimeOfItsClosedForm) {
  for (const double length : {3.0, 9.0}) {
    std::vector<Joints<1>> way;
    for (int i = 0; i <= 1000; ++i) way.emplace_back(length * i / 1000);
    const double speed = 1.5, acceleration = 4, jerk = 20;
    const Smooth<1> smooth(way, {Joints<1>(speed), Joints<1>(acceleration)}, Joints<1>(jerk));
    const double exact = length / speed + speed / acceleration + acceleration / jerk;
    EXPECT_GE(smooth.seconds, exact * (1 - 1e-9));
    EXPECT_LT(smooth.seconds, exact * 1.01);
  }
}

template <int dof>
std::vector<Joints<dof>> waves(std::mt19937& random, int count) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Joints<dof>(Joints<dof>::NullaryExpr([&] { return normal(random); })); };
  const Joints<dof> a = vector(), b = vector(), c = vector();
  std::vector<Joints<dof>> way;
  for (int i = 0; i < count; ++i) {
    const double t = 4.0 * i / (count - 1);
    way.push_back(a * std::sin(t) + b * std::cos(1.7 * t) + 0.3 * c * std::sin(2.9 * t));
  }
  return way;
}

/// Differences in time of the joints themselves against the limits.
TEST(PathJerk, NoLimitIsLeftAndLittleTimeIsLost) {
  std::mt19937 random(31);
  double lost = 0;
  for (int trial = 0; trial < 3; ++trial) {
    SCOPED_TRACE(trial);
    const path::RateLimits<3> limits{Joints<3>::Constant(2), Joints<3>::Constant(8)};
    const Joints<3> jerks = Joints<3>::Constant(120);
    const Smooth<3> smooth(waves<3>(random, 500), limits, jerks);
    ASSERT_TRUE(std::isfinite(smooth.seconds));
    EXPECT_GT(smooth.seconds, smooth.fastest);
    lost += smooth.seconds / smooth.fastest - 1;
    const double step = 2e-4;
    for (double time = 2 * step; time < smooth.seconds - 2 * step; time += smooth.seconds / 3000) {
      const Joints<3> a = smooth.at(time - 1.5 * step), b = smooth.at(time - 0.5 * step),
                      c = smooth.at(time + 0.5 * step), d = smooth.at(time + 1.5 * step);
      const double speed = ((c - b) / step).cwiseAbs().maxCoeff() / 2;
      const double acceleration = ((d - c - b + a) / (2 * step * step)).cwiseAbs().maxCoeff() / 8;
      const double jerk = ((d - 3 * c + 3 * b - a) / (step * step * step)).cwiseAbs().maxCoeff() / 120;
      ASSERT_LE(speed, 1 + 1e-6) << time;
      ASSERT_LE(acceleration, 1 + 1e-4) << time;
      ASSERT_LE(jerk, 1 + 1e-2) << time;
    }
  }
  EXPECT_LT(lost / 3, 0.2);
}

TEST(PathJerk, TheMotionBeginsAndEndsAtRestAndPassesThePoints) {
  std::mt19937 random(32);
  const path::RateLimits<3> limits{Joints<3>::Constant(2), Joints<3>::Constant(8)};
  const Smooth<3> smooth(waves<3>(random, 200), limits, Joints<3>::Constant(60));
  for (const double time : {0.0, smooth.seconds}) {
    const auto place = smooth.smoothing.at(time);
    EXPECT_LT(std::abs(place.speed) + std::abs(place.acceleration), 1e-6);
  }
  double before = -1;
  for (std::size_t i = 0; i < smooth.q.size(); ++i) {
    const double time = smooth.smoothing.time_of(i);
    ASSERT_GT(time, before);
    ASSERT_LT((smooth.at(time) - smooth.q[i]).norm(), 1e-7) << i;
    before = time;
  }
  EXPECT_EQ(before, smooth.seconds);
}

TEST(PathJerk, OddInputGetsAnAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const path::RateLimits<2> limits{Joints<2>(1, 1), Joints<2>(4, 4)};
  std::vector<Joints<2>> way;
  for (int i = 0; i <= 50; ++i) way.emplace_back(0.1 * i, 0.05 * i);
  EXPECT_TRUE(std::isnan(Smooth<2>(way, limits, Joints<2>(1, 0)).seconds));
  EXPECT_TRUE(std::isnan(Smooth<2>(way, limits, Joints<2>(1, nan)).seconds));
  EXPECT_TRUE(std::isnan(Smooth<2>({Joints<2>(0, nan), way[1], way[2]}, limits, Joints<2>(1, 1)).seconds));
  EXPECT_EQ(Smooth<2>({way[0]}, limits, Joints<2>(1, 1)).seconds, 0);
  const Smooth<2> free(way, limits, Joints<2>(inf, inf));
  EXPECT_LT(free.seconds, 1.01 * free.fastest);
}

}  // namespace
}  // namespace path_test
