// SPDX-License-Identifier: MIT
// Requests for paths that leave coordinates free, and the best motions along them.
#pragma once

#include <gtest/gtest.h>
#include <qvgen/path/free_program.h>

#include "arms.h"

namespace path_test {

/// A free coordinate as `add_named` takes it; without ends a whole circle.
struct Named {
  std::string name;
  double lower = -inverse::whole_turn / 2, upper = inverse::whole_turn / 2;
};

template <int dof = 6>
FreeRequest<dof> request_of(std::vector<Pose<double>> samples, const JointLimits<dof>& limits,
                            const std::vector<Named>& free) {
  FreeRequest<dof> request;
  request.path.samples = std::move(samples);
  request.limits = limits;
  for (const Named& each : free) {
    FreeRange range;
    range.lower = each.lower;
    range.upper = each.upper;
    range.is_circle = each.upper - each.lower >= inverse::whole_turn;
    range.count = 36;
    EXPECT_TRUE(add_named(request.freedoms, each.name, range));
  }
  return request;
}

struct SolveArm {
  const AnyArm& arm;
  Solutions<6, 16> operator()(const Pose<double>& pose, double) const { return arm.solve(pose); }
};
using Result = FreeResult<6, 16, SolveArm>;

inline Result best_of(const AnyArm& arm, const FreeRequest<6>& request) {
  return Result(SolveArm{arm}, request, arm.revolute);
}

}  // namespace path_test
