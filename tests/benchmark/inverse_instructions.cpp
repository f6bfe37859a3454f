// SPDX-License-Identifier: MIT
// Inverse kinematics of the irb6640 at random poses, to be counted by inverse_instructions.sh:
// `qvgen_inverse_instructions FORM POSES`, FORM one of lanes, scalar, unreachable, scalar_unreachable.
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <qvgen/robots/irb6640.h>

namespace {

namespace arm = qvgen::robots::irb6640;
using Pose = qvgen::Pose<double>;

/// Solves by the overload with a seed, which is not the one that is counted.
bool is_reached(const Pose& pose) {
  const arm::JointVector<double> zero = arm::JointVector<double>::Zero();
  return !arm::inverse_kinematics(pose, zero).empty();
}

std::vector<Pose> poses(int count, bool reachable) {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> turn(-3.14159265358979, 3.14159265358979);
  std::vector<Pose> result;
  for (int i = 0; i < count; ++i) {
    arm::JointVector<double> q;
    for (int k = 0; k < arm::dof; ++k) q[k] = turn(random);
    Pose pose = arm::forward_kinematics<double>(q);
    while (!reachable && is_reached(pose)) pose.position *= 1.1;
    result.push_back(pose);
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string what = argv[1];
  const auto form =
      what.rfind("scalar", 0) == 0 ? qvgen::inverse::Form::scalar : qvgen::inverse::Form::fastest;
  const auto all = poses(std::atoi(argv[2]), what.find("unreachable") == std::string::npos);
  int solutions = 0;
  for (const Pose& pose : all) {
    solutions += arm::inverse_kinematics(pose, {}, qvgen::inverse::default_tolerance, form).size();
  }
  std::printf("%.4f\n", solutions / static_cast<double>(all.size()));
  return 0;
}
