// SPDX-License-Identifier: MIT
// Limits of joint forces along a path: a mass on a slide takes the time of its closed form; no force of the
// reference's dynamics leaves its limit between the points, and some limit holds nearly everywhere; joints
// that cannot bear their load are named, between the points too.
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/path/least_time.h>
#include <qvgen/robots/iiwa14/dynamics_definitions.h>
#include <qvgen/robots/puma560/dynamics_definitions.h>

#include "reference/dynamics.h"
#include "reference/load.h"

namespace path_test {
namespace {

using namespace qvgen;
using namespace qvgen::path;

const reference::Vector3d standing{0, 0, 9.80665};

// The dynamics of a robot of the library, with a joint that may be held.
#define QVGEN_DYNAMICS(Name, robot)                                                                         \
  struct Name {                                                                                             \
    static constexpr int forces = robots::robot::dof;                                                       \
    HeldValue held = {};                                                                                    \
    template <class Scalar>                                                                                 \
    [[nodiscard]] ForceParts<Scalar, forces> parts(const robots::robot::JointVector<Scalar>& q,             \
                                                   const robots::robot::JointVector<Scalar>& slope) const { \
      return {robots::robot::mass_matrix<Scalar>(q), robots::robot::coriolis_torque<Scalar>(q, slope),      \
              robots::robot::gravity_torque<Scalar>(q)};                                                    \
    }                                                                                                       \
  }
QVGEN_DYNAMICS(Puma, puma560);
QVGEN_DYNAMICS(Iiwa, iiwa14);

reference::Chain chain_of(const std::string& robot) {
  return reference::load(QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml");
}

/// A mass on an upright slide.
struct Lift {
  static constexpr int forces = 1;
  static constexpr double mass = 3, weight = 3 * 9.80665;
  HeldValue held = {};
  template <class Scalar>
  [[nodiscard]] ForceParts<Scalar, 1> parts(const Eigen::Matrix<Scalar, 1, 1>&,
                                            const Eigen::Matrix<Scalar, 1, 1>&) const {
    using Number = Eigen::Matrix<Scalar, 1, 1>;
    return {Number(Scalar(mass)), Number(Scalar(0)), Number(Scalar(weight))};
  }
};

/// Seconds for a lift over a length, up or down.
double seconds_of_lift(double length, double most, double coulomb, int count) {
  std::vector<Joints<1>> q;
  for (int i = 0; i < count; ++i) q.emplace_back(length * i / (count - 1));
  std::vector<Timing<1, 1>::Point> points(q.size());
  const path::RateLimits<1> rates{Joints<1>::Constant(1e9), Joints<1>::Constant(1e9)};
  Timing<1, 1> timing(q.data(), q.size(), rates, points.data());
  EXPECT_TRUE(timing.lay());
  std::vector<ForceBounds<1>> bounds(q.size());
  for (std::size_t i = 0; i + 1 < q.size(); ++i) bounds[i] = force_bounds(Lift(), timing.spline(i));
  ForceLimits<1> limits;
  limits.most[0] = most;
  limits.coulomb[0] = coulomb;
  timing.limit_forces(limits, bounds.data());
  return timing.plan();
}

TEST(PathForces, ALiftTakesTheTimeOfItsClosedForm) {
  for (const double coulomb : {0.0, 5.0})
    for (const double length : {2.0, -2.0}) {
      const double against = length > 0 ? Lift::weight + coulomb : coulomb - Lift::weight;
      const double up = (50 - against) / Lift::mass, down = (50 + against) / Lift::mass;
      const double exact = std::sqrt(2 * std::abs(length) * (up + down) / (up * down));
      const double seconds = seconds_of_lift(length, 50, coulomb, 2000);
      EXPECT_GE(seconds, exact * (1 - 1e-8));
      EXPECT_LT(seconds, exact * (1 + 1e-3));
    }
}

std::vector<Values> random_way(std::mt19937& random, int count) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Values(Values::NullaryExpr([&] { return normal(random); })); };
  const Values a = vector(), b = vector(), c = vector(), middle = vector();
  std::vector<Values> q;
  for (int i = 0; i < count; ++i) {
    const double t = 3.0 * i / (count - 1);
    q.push_back(middle + 0.5 * a * std::sin(t) + 0.3 * b * std::cos(1.7 * t) + 0.1 * c * std::sin(2.9 * t));
  }
  return q;
}

std::vector<double> places_of(const std::vector<Values>& q) {
  std::vector<double> s;
  for (std::size_t i = 0; i < q.size(); ++i) s.push_back(static_cast<double>(i));
  return s;
}

/// All joints of an arm, one of which is held.
template <int forces>
Eigen::VectorXd of_all(const HeldValue& held, double value, const Values& moving) {
  Eigen::VectorXd all(forces);
  for (int i = 0, k = 0; i < forces; ++i) all[i] = i == held.joint ? value : moving[k++];
  return all;
}

/// The largest part of a force limit on a stretch, by the reference.
template <class Dynamics, class Time>
double largest_part(const Dynamics& dynamics, const reference::Chain& chain, const Time& time, std::size_t i,
                    const ForceLimits<Dynamics::forces>& limits) {
  constexpr int forces = Dynamics::forces;
  double largest = 0;
  for (int step = 0; step <= 6; ++step) {
    const double share = std::clamp(step / 6.0, 1e-6, 1 - 1e-6);  // at rest friction may be any
    Values speed, acceleration;
    time.rates(i, share, speed, acceleration);
    const auto qd = of_all<forces>(dynamics.held, 0, speed);
    Eigen::VectorXd force = reference::inverse_dynamics(
        chain, of_all<forces>(dynamics.held, dynamics.held.value, time.joints(i, share)), qd,
        of_all<forces>(dynamics.held, 0, acceleration), standing);
    for (int k = 0; k < forces; ++k) {
      force[k] += limits.viscous[k] * qd[k] + limits.coulomb[k] * ((qd[k] > 0) - (qd[k] < 0));
      largest = std::max(largest, std::abs(force[k]) / limits.most[k]);
    }
  }
  return largest;
}

/// Largest forces at rest along a way, and half as much besides.
template <class Dynamics>
ForceLimits<Dynamics::forces> limits_for(const Dynamics& dynamics, const reference::Chain& chain,
                                         const std::vector<Values>& way) {
  constexpr int forces = Dynamics::forces;
  ForceLimits<forces> limits;
  limits.most.setConstant(1);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(forces);
  for (const Values& q : way)
    limits.most = limits.most.cwiseMax(
        1.5 * reference::inverse_dynamics(chain, of_all<forces>(dynamics.held, dynamics.held.value, q), zero,
                                          zero, standing)
                  .cwiseAbs());
  return limits;
}

template <class Dynamics>
void expect_limits_kept(const Dynamics& dynamics, const std::string& robot, int count, double friction) {
  std::mt19937 random(21);
  const reference::Chain chain = chain_of(robot);
  const path::RateLimits<6> rates{Values::Constant(2.5), Values::Constant(1e6)};
  for (int trial = 0; trial < 4; ++trial) {
    SCOPED_TRACE(trial);
    const std::vector<Values> way = random_way(random, count);
    auto limits = limits_for(dynamics, chain, way);
    limits.viscous = friction * limits.most;
    limits.coulomb = 0.1 * friction * limits.most;
    LeastTime<Dynamics> least(dynamics, rates, limits);
    const LeastTimes found = least.run(places_of(way), way);
    ASSERT_TRUE(std::isfinite(found.seconds)) << found.overload.joint << " at " << found.overload.s;
    const auto time = least.timing();
    std::size_t slack = 0;
    for (std::size_t i = 0; i + 1 < found.places.size(); ++i) {
      const double part = largest_part(dynamics, chain, time, i, limits);
      ASSERT_LE(part, 1) << i;
      Values speed, ignored;
      time.rates(i, 0.5, speed, ignored);
      slack += static_cast<std::size_t>(part < 0.93 && speed.cwiseAbs().maxCoeff() < 0.93 * 2.5);
    }
    // Viscous friction that helps to brake is not counted on.
    EXPECT_LT(slack, found.places.size() / (friction > 0 ? 4 : 8));
  }
}

TEST(PathForces, NoForceLeavesItsLimitBetweenManyPoints) { expect_limits_kept(Puma(), "puma560", 400, 0); }
TEST(PathForces, NoForceLeavesItsLimitBetweenFewPoints) { expect_limits_kept(Puma(), "puma560", 25, 0); }
TEST(PathForces, FrictionIsCounted) { expect_limits_kept(Puma(), "puma560", 200, 0.1); }
TEST(PathForces, AJointThatIsHeldBearsItsLoad) { expect_limits_kept(Iiwa{{2, 0.4}}, "iiwa14", 200, 0); }

/// a, b and c stay as near to straight lines as the bounds say.
TEST(PathForces, BoundsHoldOnTheWholeStretch) {
  std::mt19937 random(22);
  for (const int count : {6, 30}) {
    const std::vector<Values> way = random_way(random, count);
    std::vector<Timing<6>::Point> points(way.size());
    const path::RateLimits<6> rates{Values::Constant(1), Values::Constant(1)};
    Timing<6> timing(way.data(), way.size(), rates, points.data());
    ASSERT_TRUE(timing.lay());
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const SplineStretch<6> on = timing.spline(i);
      const auto bounds = force_bounds(Puma(), on);
      for (const double share : {0.1, 0.5, 0.8}) {
        const Values bend = on.bend[0] + share * (on.bend[1] - on.bend[0]), q = timing.joints(i, share);
        const Values slope = on.slope[0] + 0.5 * share * on.length * (on.bend[0] + bend);
        const auto parts = Puma().parts<double>(q, slope);
        const auto off = [&](const auto& value, const auto& a, const auto& b) {
          return Values((value - a - share * (b - a)).cwiseAbs());
        };
        const auto within = [](const Values& far, const Values& bound) {
          return ((far - bound).array() <= 1e-12).all();
        };
        EXPECT_TRUE(within(off(parts.mass * slope, bounds.start.by_u, bounds.end.by_u), bounds.error.by_u));
        EXPECT_TRUE(within(off(parts.mass * bend + parts.coriolis, bounds.start.by_w, bounds.end.by_w),
                           bounds.error.by_w));
        EXPECT_TRUE(within(off(parts.gravity, bounds.start.rest, bounds.end.rest), bounds.error.rest));
      }
    }
  }
}

/// The second joint swings through the horizontal, where it bears most, between two of three points.
TEST(PathForces, AnOverloadBetweenThePointsIsNamed) {
  const reference::Chain chain = chain_of("puma560");
  std::vector<Values> way(3, Values::Zero());
  way[0][1] = -1.0;
  way[1][1] = 0.6;
  way[2][1] = 1.4;
  const auto load = [&](double angle) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q[1] = angle;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6);
    return std::abs(reference::inverse_dynamics(chain, q, zero, zero, standing)[1]);
  };
  const double at_points = std::max({load(-1.0), load(0.6), load(1.4)});
  double most = 0;
  for (int i = 0; i <= 1000; ++i) most = std::max(most, load(-1.0 + 1.6 * i / 1000));
  ASSERT_GT(most, 1.02 * at_points);
  ForceLimits<6> limits;
  limits.most[1] = 0.5 * (most + at_points);
  const path::RateLimits<6> rates{Values::Constant(2), Values::Constant(9)};
  const LeastTimes over = LeastTime<Puma>(Puma(), rates, limits).run({0, 1, 2}, way);
  EXPECT_FALSE(std::isfinite(over.seconds));
  EXPECT_EQ(over.overload.joint, 1);
  EXPECT_TRUE(over.overload.is_sure);
  EXPECT_GT(over.overload.s, 0);
  EXPECT_LT(over.overload.s, 1);
  EXPECT_GE(std::abs(over.overload.force), limits.most[1] * (1 - 1e-8));
  limits.most[1] = 1.01 * most;
  const LeastTimes good = LeastTime<Puma>(Puma(), rates, limits).run({0, 1, 2}, way);
  EXPECT_TRUE(std::isfinite(good.seconds));
  EXPECT_EQ(good.overload.joint, -1);
  limits.most.setConstant(1e9);
  EXPECT_LT(LeastTime<Puma>(Puma(), rates, limits).run({0, 1, 2}, way).seconds, good.seconds);
}

TEST(PathForces, FrictionIsFoundFromForces) {
  const Eigen::Vector3d viscous(0.5, 0, 2), coulomb(3, 0.25, 0);
  ForceLimits<3> limits;
  add_friction(
      [&](const Joints<3>& qd) {
        return Joints<3>(viscous.cwiseProduct(qd) + coulomb.cwiseProduct(qd.cwiseSign()));
      },
      limits);
  EXPECT_LT((limits.viscous - viscous).norm() + (limits.coulomb - coulomb).norm(), 1e-12);
}

TEST(PathForces, OddInputGetsAnAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const path::RateLimits<6> rates{Values::Constant(2), Values::Constant(inf)};
  ForceLimits<6> limits;
  limits.most.setConstant(200);
  const Values a = Values::Zero(), b = Values::Constant(0.3);
  const auto seconds = [&](const std::vector<Values>& way, const path::RateLimits<6>& fastest) {
    return LeastTime<Puma>(Puma(), fastest, limits).run(places_of(way), way).seconds;
  };
  EXPECT_EQ(seconds({a}, rates), 0);
  EXPECT_EQ(seconds({a, a, a}, rates), 0);
  EXPECT_GT(seconds({a, b}, rates), 0);
  EXPECT_NEAR(seconds({a, b}, rates), seconds({a, a, b, b}, rates), 1e-9);
  EXPECT_TRUE(std::isnan(seconds({a, Values::Constant(nan)}, rates)));
  const path::RateLimits<6> none{Values::Constant(inf), Values::Constant(inf)};
  EXPECT_GT(seconds({a, b}, none), 0);
  limits.most.setConstant(inf);
  EXPECT_TRUE(std::isnan(seconds({a, b}, none)));
}

}  // namespace
}  // namespace path_test
