// SPDX-License-Identifier: MIT
#include "pipeline/products/linuxcnc.h"

#include <algorithm>

#include "emit/render.h"
#include "model/followers.h"

namespace qvgen::pipeline {

void add_linuxcnc(const model::Robot& robot, RobotOutput& output) {
  const auto targets = output.counts.value("targets", nlohmann::ordered_json::object());
  const auto near = targets.find("inverse_kinematics_near");
  const bool takes_poses =
      near != targets.end() && std::find(near->begin(), near->end(), "pose") != near->end();
  if (!takes_poses || !output.counts.contains("forward_kinematics")) {
    output.missing.push_back({"linuxcnc", Missing::Kind::not_derived,
                              "it is for arms with inverse kinematics for a pose, without given joints"});
    return;
  }
  output.files.push_back(
      {"c/qvgen_" + output.robot + "_kins.c",
       emit::render("c/linuxcnc.c", {{"name", output.robot}, {"dof", model::driven_count(robot)}})});
}

}  // namespace qvgen::pipeline
