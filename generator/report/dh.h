// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "report/chain.h"

namespace qvgen::report {

/// Denavit and Hartenberg's parameters (1955) of the axes: joint i moves its frame by
/// turn(z, theta) shift(z, d) shift(x, a) turn(x, alpha), where the joint's variable is added to theta
/// (revolute) or d (prismatic). rad, m.
struct DhRow {
  double theta = 0, d = 0, a = 0, alpha = 0;
};

struct DhTable {
  Motion base;  ///< before the first joint
  std::vector<DhRow> rows;
  Motion tool;  ///< behind the last
};

/// Whatever frames the description uses. Where axes are parallel the normal leads through the origin before,
/// or through the joint's own point.
DhTable dh_table(const Chain& chain);

}  // namespace qvgen::report
