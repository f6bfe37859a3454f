// SPDX-License-Identifier: MIT
#include "derive/inverse/requests.h"

#include <algorithm>

#include "model/arithmetic.h"

namespace qvgen::derive::inverse {

using model::Robot;
using model::Vector3;

std::vector<Vector3> tool_axes(const model::InverseRequest& request) {
  if (request.tool_axis) return {*request.tool_axis};
  return {model::unit_vector(2), model::unit_vector(0), model::unit_vector(1)};
}

std::vector<std::size_t> given_joints(const Robot& robot) {
  const std::size_t count = robot.joints.size();
  const std::vector<std::string>& named = robot.inverse.given;
  const auto is_admitted = [&](const std::string& variable) {
    return named.empty() || std::find(named.begin(), named.end(), variable) != named.end();
  };
  std::vector<std::size_t> result;
  for (const std::size_t joint : {2U, 6U, 0U, 1U, 3U, 5U, 4U})
    if (joint < count && is_admitted(robot.joints[joint].variable)) result.push_back(joint);
  std::stable_partition(result.begin(), result.end(), [&](std::size_t joint) {
    return robot.joints[joint].type == model::JointType::prismatic;
  });
  return result;
}

std::vector<std::size_t> given_from_the_tool(const Robot& robot) {
  std::vector<std::size_t> joints = given_joints(robot);
  std::sort(joints.rbegin(), joints.rend());
  return joints;
}

}  // namespace qvgen::derive::inverse
