// SPDX-License-Identifier: MIT
// Ranges of motors by the joints that they move: limits that several motors share, and turns of a motor that
// turn a joint once.
//
// With tilt = (ml + mr)/2 a limit of the tilt is one of a sum: what each motor may do depends on the other.
#pragma once

#include <string>
#include <vector>

#include "model/followers.h"

namespace qvgen::model {

/// Limits of a joint that several motors move: lower <= sum of their shares <= upper, rad or m. The constant
/// of the joint's relation is in them.
struct SharedLimits {
  std::string joint;  ///< its variable
  std::string sum;    ///< its relation: "1/2 ml - 1/2 mr"
  std::vector<Share> shares;
  double lower = 0, upper = 0;

  /// Returns the sum for values of the motors.
  template <class Motors>
  [[nodiscard]] double at(const Motors& motors) const {
    double result = 0;
    for (const Share& share : shares) {
      using Index = decltype(motors.size());
      result += cln::double_approx(share.ratio) * motors[static_cast<Index>(share.driven)];
    }
    return result;
  }
  [[nodiscard]] bool hold(double value) const { return value >= lower && value <= upper; }
};

/// Returns these limits of all joints that have some, with the defaults of the description's symbols.
std::vector<SharedLimits> shared_limits(const Robot& robot);

/// Returns for each motor how much it moves at most while a joint moves by one (rad or m); 1 for joints that
/// follow none.
std::vector<double> greatest_gears(const Robot& robot);

}  // namespace qvgen::model
