// SPDX-License-Identifier: MIT
// Computed-torque control, the outlook of the thesis: the generated inverse dynamics in a closed loop around
// an arm that MuJoCo simulates.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <qvgen/cubic_trajectory.h>
#include <qvgen/robots/puma560.h>

#include "mujoco.h"
#include "reference/load.h"

namespace {

namespace arm = qvgen::robots::puma560;
using Vector = arm::JointVector<double>;

constexpr double gravity = 9.81;                 // as the simulated world has it, m/s^2
constexpr double duration = 3;                   // s
constexpr double stiffness = 400, damping = 40;  // errors decay with exp(-20 t)

struct Target {
  Vector q, qd, qdd;
};

/// Smooth through four postures, at rest at both ends.
class Path {
 public:
  Path() {
    const std::array<double, 4> reach{1.2, -0.9, 1.5, -1.1};
    for (std::size_t i = 0; i < arm::dof; ++i) {
      const double sign = i % 2 == 0 ? 1 : -1;
      std::array<double, 4> postures;
      for (std::size_t k = 0; k < 4; ++k) postures[k] = sign * reach[(k + i) % 4];
      joints_[i] = Joint::smooth({0, 1, 1.8, duration}, postures);
    }
  }
  [[nodiscard]] Target at(double time) const {
    Target target;
    for (std::size_t i = 0; i < arm::dof; ++i) {
      const auto motion = joints_[i].at(time);
      const auto row = static_cast<Eigen::Index>(i);
      target.q[row] = motion.position;
      target.qd[row] = motion.rate;
      target.qdd[row] = motion.acceleration;
    }
    return target;
  }

 private:
  using Joint = qvgen::CubicTrajectory<double, 4>;
  std::array<Joint, arm::dof> joints_;
};

struct State {
  Vector q, qd;
};

/// MuJoCo's accelerations, integrated by the classical method of Runge and Kutta while the torque is held.
class SimulatedArm {
 public:
  explicit SimulatedArm(const State& state)
      : plant_(reference::load(QVGEN_SOURCE_DIR "/generator/robots/puma560.toml")), state_(state) {}
  [[nodiscard]] const State& state() const { return state_; }
  void advance(const Vector& torque, double step) {
    const State k1 = slope(state_, torque), k2 = slope(after(k1, step / 2), torque),
                k3 = slope(after(k2, step / 2), torque), k4 = slope(after(k3, step), torque);
    state_.q += step / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q);
    state_.qd += step / 6 * (k1.qd + 2 * k2.qd + 2 * k3.qd + k4.qd);
  }

 private:
  [[nodiscard]] State after(const State& slope, double step) const {
    return {state_.q + step * slope.q, state_.qd + step * slope.qd};
  }
  State slope(const State& at, const Vector& torque) {
    return {at.qd,
            Eigen::Map<const Vector>(plant_.forward_dynamics(at.q.data(), at.qd.data(), torque.data()))};
  }
  comparison::MujocoArm plant_;
  State state_;
};

/// The controller: the arm's own dynamics cancelled, what is left is a mass, a spring and a damper a joint.
Vector computed_torque(const State& state, const Target& target, double known_gravity) {
  const Vector wanted = target.qdd + damping * (target.qd - state.qd) + stiffness * (target.q - state.q);
  return arm::inverse_dynamics(state.q, state.qd, wanted, {}, {}, known_gravity);
}

/// Largest error of a joint in the last two seconds, rad. The arm starts 0.1 rad beside its path.
double largest_error(double step, double known_gravity = gravity) {
  const Path path;
  const Target begin = path.at(0);
  SimulatedArm simulated({begin.q + Vector::Constant(0.1), begin.qd});
  double largest = 0;
  const int steps = static_cast<int>(std::lround(duration / step));
  for (int i = 0; i < steps; ++i) {
    const Target target = path.at(i * step);
    if (i * step > 1) largest = std::max(largest, (simulated.state().q - target.q).cwiseAbs().maxCoeff());
    simulated.advance(computed_torque(simulated.state(), target, known_gravity), step);
  }
  return largest;
}

TEST(ComputedTorque, FollowsAPathAtAThousandTimesASecond) { EXPECT_LT(largest_error(1e-3), 1e-3); }

// The rest is due to the time that a torque is held: of the first order in it.
TEST(ComputedTorque, ErrorIsThatOfHeldTorques) {
  const double error = largest_error(1e-3);
  const double half = largest_error(0.5e-3);
  const double quarter = largest_error(0.25e-3);
  EXPECT_NEAR(error / half, 2, 0.1);
  EXPECT_NEAR(half / quarter, 2, 0.1);
}

TEST(ComputedTorque, NeedsTheRightDynamics) {
  EXPECT_GT(largest_error(1e-3, 0.9 * gravity), 5 * largest_error(1e-3));
}

}  // namespace
