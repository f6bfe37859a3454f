// SPDX-License-Identifier: MIT
// Inverse kinematics at singular poses and near them, to be counted by singular_instructions.sh, one dump a
// pose: `qvgen_singular_instructions ROBOT FUNCTION SET POSES`. FUNCTION is inverse_kinematics, for all
// solutions, or inverse_kinematics_near, for the one next to joints that are off by at most a milliradian
// each.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/ur5.h>
#include <valgrind/callgrind.h>

namespace {

constexpr double pi = 3.14159265358979323846;

/// Joints of a set; false if there is no such set.
template <class Joints, class Random>
bool draw(const std::string& set, Random& random, Joints& q) {
  std::uniform_real_distribution<double> turn(-pi, pi);
  std::uniform_real_distribution<double> exponent(1, 12);
  for (double& value : q) value = turn(random);
  const double small = std::copysign(std::pow(10, -exponent(random)), turn(random));
  if (set == "home") {
    q << 0, -pi / 2, 0, -pi / 2, 0, 0;
  } else if (set == "theta5 = 0") {
    q[4] = 0;
  } else if (set == "theta5 = 10^-u") {
    q[4] = small;
  } else if (set == "theta3 = 0") {
    q[2] = 0;
  } else if (set == "theta3 = 10^-u") {
    q[2] = small;
  } else if (set == "45 degrees") {
    for (double& value : q) value = pi / 4 * std::round(value / (pi / 4));
  } else {
    return set == "random";
  }
  return true;
}

template <class Joints, class Forward, class Inverse>
int count(const std::string& set, int poses, const Forward& forward, const Inverse& inverse) {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> off(-1e-3, 1e-3);
  int solutions = 0;
  for (int i = 0; i < poses; ++i) {
    Joints q;
    if (!draw(set, random, q)) return 2;
    const auto pose = forward(q);
    for (double& value : q) value += off(random);
    CALLGRIND_ZERO_STATS;
    solutions += inverse(pose, q);
    CALLGRIND_DUMP_STATS;
  }
  std::printf("%d\n", solutions);
  return 0;
}

}  // namespace

#define QVGEN_COUNT(robot)                                                                           \
  if (name == #robot)                                                                                \
  return count<qvgen::robots::robot::JointVector<double>>(                                           \
      set, poses, [](const auto& q) { return qvgen::robots::robot::forward_kinematics<double>(q); }, \
      [near](const auto& pose, const auto& seed) {                                                   \
        return near ? qvgen::robots::robot::inverse_kinematics_near(pose, seed).size()               \
                    : qvgen::robots::robot::inverse_kinematics(pose).size();                         \
      })

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const std::string name = argv[1];
  const bool near = std::string(argv[2]) == "inverse_kinematics_near";
  const std::string set = argv[3];
  const int poses = std::atoi(argv[4]);
  QVGEN_COUNT(ur5);
  QVGEN_COUNT(irb6640);
  QVGEN_COUNT(puma560);
  return 2;
}
