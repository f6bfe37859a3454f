// SPDX-License-Identifier: MIT
#include "derive/inverse/wrist_axes.h"

#include "derive/inverse/wrist.h"

namespace qvgen::derive::inverse {

using symbolic::Quaternion;

Quaternion WristAxes::seen(const Quaternion& rotation) const {
  return frame ? symbolic::inverse(*frame) * rotation * *frame : rotation;
}

std::optional<WristAxes> wrist_axes(const Attempt& attempt, const std::array<std::size_t, 3>& joints) {
  const auto serves = [&](const std::array<Screw, 3>& axes) {
    return is_wrist(axes[0], axes[1], axes[2], attempt.scope);
  };
  const auto& screws = attempt.chain.screws;
  const WristAxes in_base{{screws[joints[0]], screws[joints[1]], screws[joints[2]]}, {}};
  if (serves(in_base.axes)) return in_base;
  const WristAxes in_first{in_own_frame(attempt.robot, joints, attempt.scope), screws[joints[0]].frame};
  if (serves(in_first.axes)) return in_first;
  return std::nullopt;
}

}  // namespace qvgen::derive::inverse
