// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

namespace qvgen::test {

/// Places where the inverse kinematics is known to fall short, by test and robot; README.md lists them for users. They
/// are skipped by name, so that all the others are guarded; an entry goes when its gap is closed.
inline bool is_known_gap(const std::string& test_and_robot) {
  static const std::set<std::string> gaps{
      // Two singularities at once: a circle of 1e-4 m at its boundary is held to 1e-16 m, less than the pose's rounding.
      "BranchesThatMeet/rc", "BranchesThatMeet/iiwa14_given_theta3"};
  return gaps.count(test_and_robot) > 0;
}

}  // namespace qvgen::test
