// SPDX-License-Identifier: MIT
#include "pipeline/products/nearest_pose.h"

#include <qvgen/inverse/nearest_pose.h>

#include "emit/render.h"

namespace qvgen::pipeline {

void add_nearest_pose(const model::Robot& robot, RobotOutput& output) {
  constexpr int most = qvgen::inverse::nearest::most_joints;
  if (robot.joints.size() > static_cast<std::size_t>(most)) {
    output.missing.push_back({"nearest_pose", Missing::Kind::not_derived,
                              "it is for at most " + std::to_string(most) + " joints; here, " +
                                  std::to_string(robot.joints.size())});
    return;
  }
  output.files.push_back({"include/qvgen/robots/" + robot.name + "/nearest_pose.h",
                          emit::render("cpp/nearest_pose.h", {{"name", robot.name}})});
}

}  // namespace qvgen::pipeline
