// SPDX-License-Identifier: MIT
// Laws of simulated motion.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "generated_dynamics.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

class Motion : public GeneratedDynamics {};

/// Seconds of a motion. Two are some swings of every joint: a force that is wrong shows in the first of them.
double duration() {
  const char* seconds = std::getenv("QVGEN_SECONDS");
  return seconds == nullptr ? 2 : std::atof(seconds);
}

/// A free swing without joint forces by Gauss's method of fourth order in positions and momenta p = M qd,
/// which is symplectic: of p' = C^T qd - gravity, since M' = C + C^T. Its energy does not drift, so that the
/// largest deviation on the way counts.
TEST_P(Motion, SymplecticFreeSwingKeepsItsEnergy) {
  const double g = gravity;
  const auto rates = [&](const VectorXd& y) -> VectorXd {
    return reference::solve_symmetric(robot().mass(VectorXd(y.head(dof()))), y.tail(dof()));
  };
  const auto slope = [&](const VectorXd& y) -> VectorXd {
    const VectorXd q = y.head(dof()), qd = rates(y);
    VectorXd result(2 * dof());
    result << qd, robot().coriolis_matrix(q, qd).transpose() * qd - robot().gravity(q, g);
    return result;
  };
  VectorXd y = VectorXd::Zero(2 * dof());
  y.head(dof()).setConstant(0.3);
  const auto energy = [&] {
    const VectorXd q = y.head(dof()), qd = rates(y);
    return std::pair(robot().kinetic(q, qd), robot().potential(q, g));
  };
  const double start = energy().first + energy().second;
  double scale = 1, worst = 0;
  constexpr double h = 2e-4;
  const double a = 0.25, b = std::sqrt(3.0) / 6;
  for (int step = 0; step * h < duration(); ++step) {
    VectorXd k1 = slope(y), k2 = k1;
    for (int round = 0; round < 6; ++round) {
      k1 = slope(y + h * (a * k1 + (a - b) * k2));
      k2 = slope(y + h * ((a + b) * k1 + a * k2));
    }
    y += h / 2 * (k1 + k2);
    const auto [kinetic, potential] = energy();
    scale = std::max(scale, kinetic);
    worst = std::max(worst, std::abs(kinetic + potential - start));
  }
  EXPECT_LE(worst, 1e-6 * scale);
}

/// Motion under changing joint forces, half as long: what they do, integrated along the motion, is the gain
/// in energy.
TEST_P(Motion, WorkOfTheForcesIsTheGainInEnergy) {
  const double g = gravity;
  const auto slope = [&](double t, const VectorXd& y) -> VectorXd {
    const VectorXd q = y.head(dof()), qd = y.segment(dof(), dof());
    const VectorXd torque = VectorXd::Constant(dof(), std::sin(3 * t)) - 0.5 * qd;
    VectorXd result(2 * dof() + 1);
    result << qd, robot().forward(q, qd, torque, g), torque.dot(qd);
    return result;
  };
  VectorXd y = VectorXd::Zero(2 * dof() + 1);
  y.head(dof()).setConstant(0.3);
  const auto energy = [&] {
    const VectorXd q = y.head(dof()), qd = y.segment(dof(), dof());
    return robot().kinetic(q, qd) + robot().potential(q, g);
  };
  const double start = energy();
  constexpr double h = 5e-5;
  for (int step = 0; step * h < duration() / 2; ++step) {
    const double t = step * h;
    const VectorXd k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1),
                   k3 = slope(t + h / 2, y + h / 2 * k2), k4 = slope(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_NEAR(energy() - start, y[2 * dof()], 1e-7 * (1 + std::abs(start)));
}

INSTANTIATE_TEST_SUITE_P(Robots, Motion, testing::ValuesIn(dynamics_under_test()), name_of);

}  // namespace
}  // namespace qvgen::test
