// SPDX-License-Identifier: MIT
// Joints that can be driven, for a mechanism that does not say which. A choice is as many joints as there are
// freedoms, whose rates tell those of all others: at assembled joints, the columns of the others in the
// loops' equations have full rank.
#pragma once

#include <optional>
#include <vector>

#include "model/mechanism.h"

namespace qvgen::verify {

/// No list that is longer helps anybody.
inline constexpr std::size_t most_choices = 12;

struct DrivenChoices {
  bool assembled = false;  ///< false: no joints were found at which all loops close
  std::size_t free = 0;
  std::vector<std::vector<std::size_t>> choices;  ///< in the order of the joints
  bool are_all = true;                            ///< false: there are more
};

/// `driven`: joints that every choice has.
DrivenChoices driven_choices(const model::Mechanism& mechanism, const std::vector<std::size_t>& driven = {});

/// A joint that is driven in place of a motor.
struct OtherMotor {
  std::size_t motor, joint;
};

/// Returns a joint that has a closed form of all assemblies if it is driven in place of a motor; nothing if
/// no joint has.
std::optional<OtherMotor> motor_for_closed_form(const model::Mechanism& mechanism);

}  // namespace qvgen::verify
