// SPDX-License-Identifier: MIT
#include "pipeline/limbs.h"

#include <fmt/format.h>

#include "emit/render.h"
#include "model/followers.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// The joints of a limb that follow none there, each with the joint of the whole robot that gives its value.
json joints_of(const model::Robot& robot, const model::Robot& limb, const model::Frame& tip) {
  const std::vector<std::size_t> path = model::path(robot, model::base_link, tip.joint);
  const std::vector<model::Share> shares = model::shares(robot);
  json list = json::array();
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (limb.joints[i].follows) continue;
    const model::Share& share = shares[path[i]];
    list.push_back({{"joint", share.driven},
                    {"ratio", fmt::format("{}", cln::double_approx(share.ratio))},
                    {"last", false}});
  }
  list.back()["last"] = true;
  return list;
}

}  // namespace

std::vector<model::Robot> limbs_of(const model::Mechanism& mechanism) {
  std::vector<model::Robot> limbs;
  for (const model::Frame& tip : mechanism.tips) {
    limbs.push_back(model::limb(mechanism.robot, tip));
    for (model::Joint& joint : limbs.back().joints) {
      joint.inertia = {};
      joint.drive = {};
    }
    limbs.back().inertia_parameters.clear();
  }
  return limbs;
}

void add_limbs(const model::Mechanism& mechanism, RobotOutput& output) {
  const std::vector<model::Robot> limbs = limbs_of(mechanism);
  json values{{"name", mechanism.robot.name}, {"limbs", json::array()}};
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const json joints = joints_of(mechanism.robot, limbs[i], mechanism.tips[i]);
    values["limbs"].push_back({{"tip", mechanism.tips[i].name},
                               {"limb", limbs[i].name},
                               {"joint_count", joints.size()},
                               {"joints", joints}});
  }
  output.files.push_back(
      {"include/qvgen/robots/" + mechanism.robot.name + "/limbs.h", emit::render("cpp/limbs.h", values)});
}

}  // namespace qvgen::pipeline
