// SPDX-License-Identifier: MIT
#include "verify/loops/six_rods.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "model/evaluate.h"

namespace qvgen::verify {
namespace {

using Eigen::Vector3d;
using inverse::six_rods::rod_count;

double number(const model::Expression& expression) { return model::to_double(model::evaluate(expression)); }
Vector3d numbers(const model::Vector3& v) { return {number(v[0]), number(v[1]), number(v[2])}; }

Eigen::Isometry3d pose_of(const model::Displacement& displacement) {
  Eigen::Isometry3d pose(Eigen::Translation3d(numbers(displacement.translation)));
  for (const model::Turn& turn : displacement.turns)
    pose.rotate(Eigen::AngleAxisd(number(turn.angle), numbers(turn.axis)));
  return pose;
}

std::vector<std::size_t> sorted(std::vector<std::size_t> joints) {
  std::sort(joints.begin(), joints.end());
  return joints;
}

/// The link at the other end of a rod from the base; nothing for other closures.
std::optional<std::size_t> platform_of(const model::Loop& loop) {
  if (loop.type != model::LoopType::rod || !loop.length_joint) return std::nullopt;
  const bool is_first = loop.links[0] == model::base_link;
  if (is_first == (loop.links[1] == model::base_link)) return std::nullopt;
  return loop.links[is_first ? 1 : 0];
}

/// The one link that all rods hold.
std::optional<std::size_t> platform_of(const model::Loops& loops) {
  if (loops.closures.size() != rod_count || !loops.gears.empty()) return std::nullopt;
  const auto platform = platform_of(loops.closures.front());
  for (const model::Loop& loop : loops.closures)
    if (platform_of(loop) != platform) return std::nullopt;
  return platform;
}

std::array<double, 3> in_array(const Vector3d& v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::optional<SixRods> six_rods_of(const model::Mechanism& mechanism) {
  const model::Loops& loops = mechanism.loops;
  const auto platform = platform_of(loops);
  if (!platform || !mechanism.robot.geometry.empty()) return std::nullopt;
  SixRods result;
  for (const model::Loop& loop : loops.closures) result.lengths.push_back(*loop.length_joint);
  const auto carrying = model::path(mechanism.robot, model::base_link, *platform);
  if (sorted(result.lengths) != sorted(loops.actuated) || sorted(carrying) != sorted(loops.outputs))
    return std::nullopt;
  const auto tip = std::find_if(mechanism.tips.begin(), mechanism.tips.end(),
                                [&](const model::Frame& each) { return each.joint == *platform; });
  if (tip == mechanism.tips.end()) return std::nullopt;
  result.tip = static_cast<std::size_t>(tip - mechanism.tips.begin());
  const Eigen::Isometry3d from_link = pose_of(tip->placement).inverse();
  for (std::size_t i = 0; i < rod_count; ++i) {
    const model::Loop& loop = loops.closures[i];
    const bool is_first = loop.links[0] == model::base_link;
    result.ends.base[i] = in_array(numbers(loop.points[is_first ? 0 : 1]));
    result.ends.platform[i] = in_array(from_link * numbers(loop.points[is_first ? 1 : 0]));
  }
  return result;
}

}  // namespace qvgen::verify
