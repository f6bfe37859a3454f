// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/chain.h"
#include "report/drawing.h"

namespace qvgen::report {

/// Places that the tool point reaches: a half plane through the axis of the first joint, found by moving the
/// joints through their ranges at `samples` joint vectors, the same in every run.
struct Reach {
  static constexpr int samples = 40000;
  double farthest = 0;  ///< from the axis's point nearest to the arm's base (m)
  double nearest = 0;
  double widest = 0;                          ///< from the axis itself
  double lowest = 0, highest = 0;             ///< along it
  std::vector<std::array<double, 2>> points;  ///< distance from the axis, height
};
Reach reach_of(const Chain& chain);

/// The points as an SVG of small squares with a scale in metres.
std::string cross_section(const Reach& reach, const Caption& caption);

}  // namespace qvgen::report
