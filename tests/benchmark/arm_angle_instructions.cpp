// SPDX-License-Identifier: MIT
// Seven joints by their arm angle, at random poses within the limits, to be counted by
// arm_angle_instructions.sh: `qvgen_arm_angle_instructions FORM POSES`, FORM one of given, arm_angle,
// intervals, within, within_near.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include <qvgen/robots/iiwa14.h>
#include <valgrind/callgrind.h>

namespace {

namespace arm = qvgen::robots::iiwa14;

/// Returns the limits of the data sheet, rad.
qvgen::JointLimits<arm::dof> data_sheet_limits() {
  constexpr double degree = 3.14159265358979323846 / 180;
  arm::JointVector<double> most;
  most << 170, 120, 170, 120, 170, 120, 175;
  return {-most * degree, most * degree};
}

/// How many rows, or intervals, a pose has; -1 if there is no such form.
int solve(const std::string& form, const qvgen::Pose<double>& pose, const arm::JointVector<double>& q,
          double psi, const qvgen::JointLimits<arm::dof>& limits) {
  if (form == "given") return arm::inverse_kinematics_given_theta3(pose, q[2]).size();
  if (form == "arm_angle") return arm::inverse_kinematics_arm_angle(pose, psi).size();
  if (form == "intervals") return arm::arm_angle_intervals(pose, limits).size();
  if (form == "within") return arm::inverse_kinematics(pose, limits).size();
  if (form == "within_near") return arm::inverse_kinematics(pose, q, limits).size();
  return -1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int poses = std::atoi(argv[2]);
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> share(0, 1);
  const qvgen::JointLimits<arm::dof> limits = data_sheet_limits();
  int sum = 0;
  for (int i = 0; i < poses; ++i) {
    arm::JointVector<double> q;
    for (int k = 0; k < arm::dof; ++k)
      q[k] = limits.lower[k] + share(random) * (limits.upper[k] - limits.lower[k]);
    const qvgen::Pose<double> pose = arm::forward_kinematics<double>(q);
    const double psi = arm::arm_angle(q);
    CALLGRIND_TOGGLE_COLLECT;
    const int count = solve(argv[1], pose, q, psi, limits);
    CALLGRIND_TOGGLE_COLLECT;
    if (count < 0) return 2;
    sum += count;
  }
  std::printf("%.2f\n", sum / static_cast<double>(poses));
  return 0;
}
