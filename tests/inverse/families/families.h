// SPDX-License-Identifier: MIT
// Families of arms that are written for the tests, by their names: "pitch_004" is of the family "pitch". All
// are in one program; each law has the arms of its families.
#pragma once

#include <set>

#include "robot_under_test.h"
#include "unsolved.h"

namespace qvgen::test {

using Families = std::set<std::string>;

/// The families of each law.
namespace families {
inline const Families six_joints{"pieper", "parallel", "twists", "zeros"};
inline const Families slides{"slides"};
inline const Families fewer_joints{"five", "four", "codes", "turned", "machines"};
inline const Families pitch{"pitch"};
inline const Families inclined{"inclined", "heading"};
inline const Families directed{"directed"};
inline const Families seven{"seven"};
inline const Families unstructured{"unstructured"};
}  // namespace families

/// True if an arm of this name is of one of the families.
inline bool is_of(const Families& families, const std::string& name) {
  return families.contains(name.substr(0, name.rfind('_')));
}

template <class Arm>
std::vector<Arm> those_of(const Families& families, const std::vector<Arm>& all) {
  std::vector<Arm> some;
  for (const Arm& arm : all)
    if (is_of(families, arm.name)) some.push_back(arm);
  return some;
}

/// The arms for which an inverse kinematics was derived.
inline std::vector<InverseUnderTest> inverses_of(const Families& families) {
  return those_of(families, inverses());
}

inline std::vector<Unsolved> unsolved_of(const Families& families) { return those_of(families, unsolved()); }

/// How many arms were written, solved or not.
inline std::size_t written_arms(const Families& families) {
  std::size_t count = 0;
  for (const std::string& name : written_arms()) count += is_of(families, name) ? 1 : 0;
  return count;
}

}  // namespace qvgen::test
