// SPDX-License-Identifier: MIT
#include "model/coordinates.h"

#include "model/followers.h"

namespace qvgen::model {

std::size_t base_motions(const Robot& robot) { return robot.floating_base ? motions_of_body : 0; }

std::size_t base_bodies(const Robot& robot) { return robot.floating_base ? 1 : 0; }

std::size_t body_count(const Robot& robot) { return base_bodies(robot) + robot.joints.size(); }

std::string base_coordinate(std::size_t motion) { return "#" + std::to_string(motion); }

std::vector<std::string> coordinates(const Robot& robot) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < base_motions(robot); ++k) names.push_back(base_coordinate(k));
  for (const std::string& variable : variables(robot)) names.push_back(variable);
  return names;
}

std::size_t coordinate_count(const Robot& robot) { return base_motions(robot) + driven_count(robot); }

}  // namespace qvgen::model
