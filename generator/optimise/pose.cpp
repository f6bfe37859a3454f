// SPDX-License-Identifier: MIT
#include "optimise/pose.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "canonical/right_angles.h"
#include "dag/import.h"
#include "derive/kinematics/forward_kinematics.h"
#include "verify/same_pose.h"

namespace qvgen::optimise {
namespace {

/// Number of zero poses whose forms are counted, those with a free rotation at the end first: arms of eight
/// joints have hundreds.
constexpr std::size_t counted = 64;

/// More cost time and gain next to nothing.
constexpr std::size_t searched = 3;

/// Returns the cost of the cheapest form as it is derived, before any pass.
double promise(const canonical::Arm& arm, const passes::CostModel& cost) {
  double least = std::numeric_limits<double>::infinity();
  for (const derive::Form& form : derive::forward_kinematics(arm.robot).forms)
    least = std::min(least, passes::cost(dag::count(dag::import(form.program)), cost));
  return least;
}

}  // namespace

std::vector<canonical::Arm> arms_for_pose(const model::Robot& described, const passes::CostModel& cost) {
  std::vector<canonical::Arm> models = canonical::right_angled_models(described);
  if (models.empty()) return {canonical::for_kinematics(described)};
  if (models.size() <= searched) return models;
  models.resize(std::min(models.size(), counted));
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < models.size(); ++i) order.emplace_back(promise(models[i], cost), i);
  std::sort(order.begin(), order.end());
  std::vector<canonical::Arm> best;
  for (std::size_t i = 0; i < searched; ++i) best.push_back(std::move(models[order[i].second]));
  return best;
}

Pose forward_kinematics(const model::Robot& described, const OptimiseOptions& options) {
  std::optional<Pose> best;
  for (canonical::Arm& arm : arms_for_pose(described, options.cost)) {
    OptimiseOptions one = options;
    one.also_fewest = false;
    Optimised function = optimise(derive::forward_kinematics(arm.robot), one);
    if (best &&
        passes::cost(function.counts, options.cost) >= passes::cost(best->function.counts, options.cost))
      continue;
    best = Pose{std::move(arm), std::move(function)};
  }
  verify::certify_same_pose(described, best->arm);
  if (options.also_fewest) best->function = optimise(derive::forward_kinematics(best->arm.robot), options);
  return std::move(*best);
}

}  // namespace qvgen::optimise
