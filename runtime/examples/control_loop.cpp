// SPDX-License-Identifier: MIT
// A control loop at 1 kHz: the tool follows a circle, joint values come from the inverse kinematics next to
// the joints of the cycle before, joint forces from the inverse dynamics. Nothing in the loop allocates,
// locks or throws.
#include <cmath>
#include <cstdio>

#include <qvgen/robots/puma560.h>

namespace arm = qvgen::robots::puma560;  // change the arm by changing a namespace
using Joints = arm::JointVector<double>;

namespace {

constexpr double period = 1e-3;        // s
constexpr double longest_step = 0.02;  // rad a cycle; a longer one is a jump to another branch

/// Returns the pose that the tool is to have at a time, s: a circle of 5 cm a second, the orientation as it
/// is at first.
qvgen::Pose<double> wanted(const qvgen::Pose<double>& first, double time) {
  constexpr double radius = 0.05, turn = 6.283185307179586;
  qvgen::Pose<double> pose = first;
  pose.position.x() += radius * (std::cos(turn * time) - 1);
  pose.position.y() += radius * std::sin(turn * time);
  return pose;
}

}  // namespace

int main() {
  Joints q, rates = Joints::Zero();
  q << 0.2, -0.6, 0.4, 0.1, 0.7, -0.3;
  const qvgen::Pose<double> first = arm::forward_kinematics(q);
  double farthest = 0, largest = 0;
  for (int cycle = 1; cycle <= 1000; ++cycle) {
    const qvgen::Pose<double> target = wanted(first, cycle * period);
    const auto near = arm::inverse_kinematics_near(target, q, arm::Limits());
    if (near.empty() || (near[0].q - q).cwiseAbs().maxCoeff() > longest_step) {
      std::printf("stopped in cycle %d: status %d\n", cycle, static_cast<int>(near.status));
      return 1;
    }
    const Joints next_rates = (near[0].q - q) / period;
    const Joints accelerations = cycle == 1 ? Joints::Zero().eval() : Joints((next_rates - rates) / period);
    const Joints forces = arm::inverse_dynamics(near[0].q, next_rates, accelerations);  // to the drives, N m
    q = near[0].q;
    rates = next_rates;
    farthest = std::fmax(farthest, (arm::forward_kinematics(q).position - target.position).norm());
    largest = std::fmax(largest, forces.cwiseAbs().maxCoeff());
  }
  std::printf("1000 cycles, off by %.1e m at the most, joint forces up to %.0f N m\n", farthest, largest);
  return farthest < 1e-12 && largest < 200 ? 0 : 1;
}
