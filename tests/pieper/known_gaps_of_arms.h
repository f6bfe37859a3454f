// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

namespace qvgen::test {

/// Arms that fall short at singular places (nothing wrong is returned, but not all), by test and arm, skipped by name so that
/// all others are guarded.
inline bool is_known_gap_of_random_arms(const std::string& test_and_arm) {
  // Two singularities at once: one of a hundred poses where branches meet.
  static const std::set<std::string> gaps{"BranchesThatMeet/parallel_093", "BranchesThatMeet/parallel_185"};
  return gaps.count(test_and_arm) > 0;
}

}  // namespace qvgen::test
