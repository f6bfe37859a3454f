// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derive/kinematics/zero_reference.h"
#include "symbolic/program.h"

namespace qvgen::derive {

struct PositionForm {
  std::string name;
  /// Takes the tool's orientation, which some forms use.
  std::function<symbolic::Vector(symbolic::Program&, const symbolic::Quaternion&)> build;
};

/// Ways to compute the tool's position from the tip to the base, parallel neighbours merged: in full angles,
/// in full angles made of half angles, and with the last offset turned by the orientation quaternion.
std::vector<PositionForm> position_forms(const ZeroReferenceChain& chain);

/// The position in full angles without names, multiplied out.
symbolic::Vector written_out_position(const ZeroReferenceChain& chain);

}  // namespace qvgen::derive
