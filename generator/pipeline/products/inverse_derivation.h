// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/general.h"
#include "derive/inverse/inverse.h"
#include "emit/cpp/inverse/frames.h"

namespace qvgen::pipeline {

/// All that can be derived of an arm's inverse kinematics: closed forms, or the elimination for six joints
/// without structure, or the reasons why there is neither.
struct InverseDerivation {
  canonical::Arm canonical;  ///< whose symbols are private names (model/private_names.h)
  emit::InverseArm arm;      ///< the arm that the plans are for
  std::vector<derive::inverse::Plan> plans;
  derive::inverse::GeneralDerivation general;  ///< found only if there are no plans
  std::vector<std::string> reasons;            ///< of what was not found, also if something else was

  [[nodiscard]] bool found() const { return !plans.empty() || general.found; }
};

InverseDerivation derive_inverse(const model::Robot& described);

}  // namespace qvgen::pipeline
