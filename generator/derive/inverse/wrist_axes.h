// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "derive/inverse/attempt.h"

namespace qvgen::derive::inverse {

/// The axes of three revolute joints that turn the tool, as numbers: in the base frame if they are that
/// there, else in the first one's own frame.
struct WristAxes {
  std::array<Screw, 3> axes;
  std::optional<symbolic::Quaternion> frame;  ///< the first one's, if they are seen from there

  /// A rotation of the base frame as it is seen from where the axes are.
  [[nodiscard]] symbolic::Quaternion seen(const symbolic::Quaternion& rotation) const;
};

/// Nothing if not all of them turn, if neighbouring axes are parallel, or if they are no numbers anywhere.
std::optional<WristAxes> wrist_axes(const Attempt& attempt, const std::array<std::size_t, 3>& joints);

}  // namespace qvgen::derive::inverse
