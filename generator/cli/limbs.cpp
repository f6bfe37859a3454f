// SPDX-License-Identifier: MIT
#include "cli/limbs.h"

#include <fmt/format.h>

#include "model/followers.h"
#include "model/mechanism.h"

namespace qvgen::cli {
namespace {

using description::ReadResult;

std::string kind_of(const model::Joint& joint) {
  return joint.type == model::JointType::revolute ? "turns" : "slides";
}

/// Lines of a tree, each joint below the one that carries it.
class Tree {
 public:
  explicit Tree(const ReadResult& result) : robot_(*result.robot), tips_(result.tips) {}

  std::vector<std::string> lines() {
    lines_.push_back(fmt::format("{}: {}, {} joints, {} tips", robot_.name,
                                 robot_.floating_base ? "the base moves freely" : "the base stands still",
                                 robot_.joints.size(), tips_.size()));
    add_behind(model::base_link, 1);
    return std::move(lines_);
  }

 private:
  void add_behind(std::size_t carrier, std::size_t depth) {
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      if (model::parent_of(robot_, i) != carrier) continue;
      lines_.push_back(std::string(2 * depth, ' ') + words_of(i));
      add_behind(i, depth + 1);
    }
  }

  [[nodiscard]] std::string words_of(std::size_t joint) const {
    const model::Joint& each = robot_.joints[joint];
    std::string words = each.variable + " " + kind_of(each);
    if (!each.follows.empty()) words += ", = " + model::relation_text(each.follows);
    for (const model::Frame& tip : tips_)
      if (tip.joint == joint) words += " -> " + tip.name;
    return words;
  }

  const model::Robot& robot_;
  const std::vector<model::Frame>& tips_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<ReadResult> limbs_of(const ReadResult& result) {
  std::vector<ReadResult> limbs;
  if (result.tips.empty()) {
    limbs.push_back(result);
    limbs.back().robot->floating_base.reset();
  }
  for (const model::Frame& tip : result.tips) {
    limbs.push_back(result);
    ReadResult& limb = limbs.back();
    limb.robot = model::limb(*result.robot, tip);
    limb.robot->floating_base.reset();
    for (model::Joint& joint : limb.robot->joints) joint.inertia = {}, joint.drive = {};
    limb.robot->inertia_parameters.clear();
    limb.tips.clear();
  }
  return limbs;
}

std::vector<ReadResult> limbs_of(const std::vector<ReadResult>& results) {
  std::vector<ReadResult> all;
  for (const ReadResult& result : results)
    for (ReadResult& limb : limbs_of(result)) all.push_back(std::move(limb));
  return all;
}

std::vector<std::string> tree_lines(const ReadResult& result) { return Tree(result).lines(); }

}  // namespace qvgen::cli
