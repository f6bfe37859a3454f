// SPDX-License-Identifier: MIT
// Intervals in which a true value lies with 95 %, for reports.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

/// Returns how many standard deviations reach to the end of a 95 % interval, for deviations that were
/// themselves estimated with so many degrees of freedom (Student; by Cornish and Fisher).
inline double reach_of_95(double freedom) {
  constexpr double z = 1.959964;
  return z + (z * z * z + z) / (4 * std::max(1.0, freedom)) +
         (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * std::pow(std::max(1.0, freedom), 2));
}

/// One error of the arm with its interval; mm or mrad.
struct ErrorEstimate {
  std::string name, unit;
  double value = 0, deviation = 0, low = 0, high = 0;
  [[nodiscard]] bool is_significant() const { return low > 0 || high < 0; }
};

/// Returns the errors that were found.
std::vector<ErrorEstimate> error_estimates(const Calibration& found);

/// Returns sentences on pairs of errors whose estimates hang together: the correlation is above 0.9.
std::vector<std::string> correlated(const Calibration& found);

}  // namespace qvgen::calibrate
