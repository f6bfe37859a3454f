// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::test::sources {

/// The first three joints of an arm, from its axes at random configurations.
struct ArmClass {
  std::string types;      ///< "RPR"
  std::string relations;  ///< of axes 1 and 2, of 2 and 3: "perpendicular, parallel"
  std::string joints;     ///< "theta1 turns, d2 slides, theta3 turns"
  int directions = 0;     ///< that the axes of its turns span
  [[nodiscard]] std::string workspace() const;
};
ArmClass class_of(const std::string& robot);

}  // namespace qvgen::test::sources
