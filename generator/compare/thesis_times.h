// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::compare {

/// Table 3.18 of the thesis: seconds for a million poses of a three-joint arm with Euler wrist by
/// Denavit-Hartenberg matrices and by quaternion/vector pairs, in Matlab on a Pentium M of 1.73 GHz, and the
/// workspace as printed there.
struct ThesisTimes {
  std::string robot;
  double matrices;
  double pairs;
  std::string workspace;
};

/// In the printed order: by the difference of the two.
const std::vector<ThesisTimes>& thesis_times();

}  // namespace qvgen::compare
