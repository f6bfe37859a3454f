// SPDX-License-Identifier: MIT
// A payload by logs without and with it: the same arm, whose last link has ten parameters more in the second.
#pragma once

#include <array>
#include <vector>

#include "identify/consistent.h"

namespace qvgen::identify {

/// A body on the last link, in the frame of that link.
struct Payload {
  double mass = 0;                     ///< kg
  Eigen::Vector3d centre;              ///< m
  std::array<double, 6> inertia = {};  ///< kg m^2 about the centre: xx yy zz xy yz xz
};

struct PayloadEstimate {
  Standard parameters;             ///< as of a link, about the origin of its frame
  std::array<bool, 10> told = {};  ///< false for those that the data do not tell
  Payload body, deviation;         ///< with standard deviations; of what is told
  double condition = 0;
};

/// Returns the payload by equations of logs without and with it. Drives and links are the same in both.
PayloadEstimate payload_of(const ArmRegressor& arm, const Equations& without, const Equations& with);

}  // namespace qvgen::identify
