// SPDX-License-Identifier: MIT
#include "model/mechanism.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "model/arithmetic.h"
#include "model/inverse.h"

namespace qvgen::model {
namespace {

using Places = std::map<std::size_t, std::size_t>;  ///< index in the whole robot -> index in the limb

bool has_joint(const Robot& robot, const std::string& variable) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [&](const Joint& joint) { return joint.variable == variable; });
}

/// Returns the leaders that a limb has no more: joints outside, and motors that move a joint outside.
std::set<std::string> lost_leaders(const Robot& whole, const Robot& limb) {
  std::set<std::string> lost;
  for (const Joint& joint : whole.joints) {
    if (has_joint(limb, joint.variable)) continue;
    lost.insert(joint.variable);
    for (const Lead& lead : joint.follows)
      if (!has_joint(limb, lead.variable)) lost.insert(lead.variable);
  }
  return lost;
}

/// Gives joints that follow something outside of the limb a value of their own. A motor that moved such a
/// joint is lost, too.
void keep_leaders(const Robot& whole, Robot& limb) {
  std::set<std::string> lost = lost_leaders(whole, limb);
  const auto is_lost = [&](const Lead& lead) { return lost.count(lead.variable) > 0; };
  const auto follows_lost = [&](const Joint& joint) {
    return std::any_of(joint.follows.begin(), joint.follows.end(), is_lost);
  };
  const auto next = [&] { return std::find_if(limb.joints.begin(), limb.joints.end(), follows_lost); };
  for (auto joint = next(); joint != limb.joints.end(); joint = next()) {
    for (const Lead& lead : joint->follows)
      if (!has_joint(limb, lead.variable)) lost.insert(lead.variable);
    joint->follows.clear();
  }
  std::erase_if(limb.motors, [&](const Motor& motor) { return lost.count(motor.variable) > 0; });
}

std::vector<Frame> frames_of_limb(const Robot& robot, const Places& places, const Frame& tip) {
  std::vector<Frame> frames;
  for (const Frame& frame : robot.frames) {
    const auto place = places.find(frame.joint);
    if (place == places.end() || (frame.name == tip.name && frame.joint == tip.joint)) continue;
    frames.push_back({frame.name, place->second, frame.placement});
  }
  return frames;
}

Robot chain_between(const Robot& robot, std::size_t from, const Frame& to) {
  Robot chain = robot;
  chain.name += "_" + to.name;
  chain.title += ", limb to " + to.name;
  chain.floating_base.reset();
  chain.has_loops = false;
  chain.joints.clear();
  Places places;
  const std::vector<std::size_t> joints = path(robot, from, to.joint);
  for (std::size_t i = 0; i < joints.size(); ++i) places[joints[i]] = i;
  for (const std::size_t joint : joints) {
    chain.joints.push_back(robot.joints[joint]);
    chain.joints.back().parent.reset();
  }
  keep_leaders(robot, chain);
  chain.frames = frames_of_limb(robot, places, to);
  chain.tool = to.placement;
  return chain;
}

}  // namespace

std::size_t parent_of(const Robot& robot, std::size_t joint) {
  if (const auto& parent = robot.joints.at(joint).parent) return *parent;
  return joint == 0 ? base_link : joint - 1;
}

void set_parent(Robot& robot, std::size_t joint, std::size_t parent) {
  robot.joints.at(joint).parent.reset();
  if (parent_of(robot, joint) != parent) robot.joints[joint].parent = parent;
}

bool branches(const Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const Joint& joint) { return joint.parent.has_value(); });
}

bool is_chain(const Robot& robot) { return !robot.has_loops && !branches(robot); }

void take_chain(Mechanism& mechanism) {
  auto& [robot, tips, loops] = mechanism;
  robot.has_loops = !loops.empty();
  if (tips.empty() || !is_chain(robot)) return;
  const auto last = std::find_if(tips.begin(), tips.end(), [&robot = robot](const Frame& tip) {
    return tip.joint + 1 == robot.joints.size();
  });
  if (last == tips.end()) return;
  robot.tool = last->placement;
  std::erase_if(robot.frames,
                [&](const Frame& frame) { return frame.name == last->name && frame.joint == last->joint; });
  if (tips.size() == 1) tips.clear();
}

std::vector<std::size_t> path(const Robot& robot, std::size_t from, std::size_t to) {
  std::vector<std::size_t> joints;
  for (std::size_t joint = to; joint != from; joint = parent_of(robot, joint)) {
    if (joint == base_link) throw std::domain_error("no chain of joints leads from one link to the other");
    joints.push_back(joint);
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

Robot limb(const Robot& robot, const Frame& to) { return chain_between(robot, base_link, to); }

Robot limb(const Robot& robot, const Frame& from, const Frame& to) {
  Robot chain = chain_between(robot, from.joint, to);
  if (chain.joints.empty()) throw std::domain_error("no joint between " + from.name + " and " + to.name);
  chain.base = inverse(from.placement);
  return chain;
}

}  // namespace qvgen::model
