// SPDX-License-Identifier: MIT
#include "model/motor_ranges.h"

#include <algorithm>

#include <cln/real.h>

#include "model/evaluate.h"

namespace qvgen::model {

std::vector<SharedLimits> shared_limits(const Robot& robot) {
  std::vector<SharedLimits> result;
  const Bindings values = default_bindings(robot);
  const std::vector<std::vector<Share>> all = shares(robot);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (joint.follows.size() < 2 || !joint.limits) continue;
    result.push_back({joint.variable, relation_text(joint.follows), all[i],
                      to_double(evaluate(joint.limits->lower, values)),
                      to_double(evaluate(joint.limits->upper, values))});
  }
  return result;
}

std::vector<double> greatest_gears(const Robot& robot) {
  std::vector<double> gears(driven_count(robot), 1);
  for (const std::vector<Share>& row : shares(robot))
    for (const Share& share : row)
      gears[share.driven] = std::max(gears[share.driven], 1 / std::abs(cln::double_approx(share.ratio)));
  return gears;
}

}  // namespace qvgen::model
