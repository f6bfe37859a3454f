// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::compare {

/// The fewest operations of inverse dynamics that were published, or that another generator makes of the same
/// arm.
struct PublishedCounts {
  std::string robot;
  std::string inertias;  ///< "symbols, base parameters" or "numbers"
  int multiplications;
  int additions;
};
const std::vector<PublishedCounts>& published_counts();

}  // namespace qvgen::compare
