// SPDX-License-Identifier: MIT
#include "model/followers.h"

#include <algorithm>

namespace qvgen::model {

bool has_followers(const Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const Joint& joint) { return joint.follows.has_value(); });
}

Robot without_followers(const Robot& robot) {
  Robot result = robot;
  std::erase_if(result.joints, [](const Joint& joint) { return joint.follows.has_value(); });
  return result;
}

std::vector<Share> shares(const Robot& robot) {
  std::vector<std::size_t> places;
  std::size_t driven = 0;
  for (const Joint& joint : robot.joints) places.push_back(joint.follows ? 0 : driven++);
  std::vector<Share> result;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const auto& follows = robot.joints[i].follows;
    result.push_back(follows ? Share{places[follows->joint], follows->ratio} : Share{places[i], 1});
  }
  return result;
}

std::size_t driven_count(const Robot& robot) {
  return static_cast<std::size_t>(std::count_if(robot.joints.begin(), robot.joints.end(),
                                                [](const Joint& joint) { return !joint.follows; }));
}

std::vector<std::string> variables(const Robot& robot) {
  std::vector<std::string> result;
  for (const Joint& joint : robot.joints)
    if (!joint.follows) result.push_back(joint.variable);
  return result;
}

}  // namespace qvgen::model
