// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derive/inverse/elimination.h"
#include "derive/inverse/inverse.h"
#include "pipeline/products/inverse_outer.h"

namespace qvgen::pipeline {

/// All that can be derived of an arm's inverse kinematics: closed forms, or the elimination for arms without
/// structure that come down to six joints, or the reasons why there is neither.
struct InverseDerivation {
  /// Each found, for an arm whose symbols are private names (model/private_names.h).
  std::vector<derive::inverse::Derivation> closed_forms;
  /// Only if there is no closed form, or none but a quartic that is much slower.
  std::vector<derive::inverse::EliminationDerivation> eliminations;
  std::vector<std::string> reasons;  ///< of what was not found, also if something else was
  model::Robot arm = {};      ///< what it is derived for: the robot in joints, without its outer joints
  model::Robot coupled = {};  ///< its joints, each with its leaders
  std::optional<OuterJoints> outer = {};  ///< the arm's, if several joints are given

  [[nodiscard]] bool found() const { return !closed_forms.empty() || !eliminations.empty(); }
};

InverseDerivation derive_inverse(const model::Robot& described);

}  // namespace qvgen::pipeline
