// SPDX-License-Identifier: MIT
#include "description/tree/loops.h"

#include <algorithm>

#include "description/names.h"
#include "model/arithmetic.h"

namespace qvgen::description::tree {
namespace {

/// Adds the loops of one file.
class Closing {
 public:
  Closing(Context& context, const std::vector<Node>& nodes, TreeReader& reader, const model::Robot& robot)
      : context_(&context), nodes_(&nodes), reader_(&reader), robot_(&robot) {}

  std::optional<model::Loop> loop_of(const Closure& closure) {
    model::Loop loop;
    loop.type = closure.type;
    std::array<model::Displacement, 2> frames;
    std::vector<model::Turn> first_turns;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto place = place_of(closure, i);
      if (!place) return std::nullopt;
      if (i == 0) first_turns = place->placement.turns;
      loop.links.at(i) = place->joint;
      frames.at(i) = folded(place->placement, closure.frames.at(i));
      loop.points.at(i) = frames.at(i).translation;
    }
    if (loop.links[0] == loop.links[1]) return within_one_link(closure);
    loop.turns = folded(frames[0], inverse(frames[1])).turns;
    if (closure.axis) loop.axis = turned(first_turns, *closure.axis);
    loop.length = closure.length;
    if (closure.length_joint) loop.length_joint = length_joint(closure);
    return loop;
  }

  std::vector<std::size_t> joints_of(const JointNames& list, bool may_lack) {
    std::vector<std::size_t> joints;
    for (const std::string& name : list.names) {
      const auto joint = reader_->joint_called(name);
      if (!joint && !may_lack) report_joint(name, list.place);
      if (joint && std::find(joints.begin(), joints.end(), *joint) == joints.end()) joints.push_back(*joint);
    }
    return joints;
  }

 private:
  std::optional<model::Frame> place_of(const Closure& closure, std::size_t end) {
    const std::size_t node = closure.nodes.at(end);
    const auto place = reader_->find_place(node);
    if (!place && robot_->floating_base)
      context_->error(closure.place, "the base floats, and a loop ties it to '" + (*nodes_)[node].name + "'",
                      "leave the loop out, for what holds a foot is a contact (qvgen/contacts.h), or leave "
                      "--floating out");
    else if (!place)
      context_->error(closure.place,
                      "a loop at '" + (*nodes_)[node].name + "', which does not belong to the robot",
                      "choose another --base, or leave the loop out");
    return place;
  }

  /// Links that nothing moves against each other: what ties them is no loop.
  std::nullopt_t within_one_link(const Closure& closure) {
    context_->warning(closure.place,
                      "nothing moves between '" + (*nodes_)[closure.nodes[0]].name + "' and '" +
                          (*nodes_)[closure.nodes[1]].name + "': what ties them is no loop",
                      "leave it out");
    return std::nullopt;
  }

  std::optional<std::size_t> length_joint(const Closure& closure) {
    const auto joint = reader_->joint_called(*closure.length_joint);
    if (!joint)
      report_joint(*closure.length_joint, closure.place);
    else if (robot_->joints[*joint].type != model::JointType::prismatic)
      context_->error(closure.place, "joint " + *closure.length_joint + " turns: it is no length",
                      "name a prismatic joint, whose value is the length of the rod, or a number");
    return joint;
  }

  void report_joint(const std::string& name, Place place) {
    std::vector<std::string> names;
    for (const Node& node : *nodes_)
      if (node.moves && !node.joint.empty() && names.size() < many_names) names.push_back(node.joint);
    const std::string near = nearest(name, names);
    context_->error(place, "there is no joint '" + name + "' that moves",
                    near.empty() ? "name a joint of the file" : "did you mean '" + near + "'?");
  }

  Context* context_;
  const std::vector<Node>* nodes_;
  TreeReader* reader_;
  const model::Robot* robot_;
};

}  // namespace

std::vector<std::size_t> with_closures(const std::vector<Node>& nodes, std::size_t base,
                                       const std::vector<Closure>& closures, std::vector<std::size_t> tips) {
  for (const Closure& closure : closures)
    for (const std::size_t node : closure.nodes)
      if (node != base && path_between(nodes, {base, node})) tips.push_back(node);
  return tips;
}

void close_loops(Context& context, const std::vector<Node>& nodes, TreeReader& reader, const Loops& loops,
                 const std::vector<Closure>& closures, model::Mechanism& mechanism) {
  Closing closing(context, nodes, reader, mechanism.robot);
  for (const Closure& closure : closures)
    if (const auto loop = closing.loop_of(closure)) mechanism.loops.closures.push_back(*loop);
  if (mechanism.loops.empty() && !follow_powers(context)) return;
  const std::size_t joints = mechanism.robot.joints.size();
  mechanism.loops.gears = reader.gears(mechanism.robot);
  mechanism.loops.actuated = closing.joints_of(loops.actuated, loops.may_lack);
  for (std::size_t motor = joints; loops.may_lack && motor < mechanism.robot.joints.size(); ++motor)
    mechanism.loops.actuated.push_back(motor);
  if (mechanism.loops.actuated.empty()) drive_leaders(mechanism);
  mechanism.loops.outputs = closing.joints_of(loops.outputs, false);
}

}  // namespace qvgen::description::tree
