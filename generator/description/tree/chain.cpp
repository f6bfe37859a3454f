// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "description/followers.h"
#include "description/named_frames.h"
#include "description/tree/tree.h"
#include "model/arithmetic.h"

namespace qvgen::description::tree {
namespace {

// More links in a row, or fixed to one another, than any robot has; each costs a few microseconds.
constexpr std::size_t most_links = 1000;

class ChainReader {
 public:
  ChainReader(Context& context, const std::vector<Node>& nodes, const ReadSegment& read)
      : context_(&context), nodes_(&nodes), read_(&read) {}

  void read(const std::vector<std::size_t>& path, model::Robot& robot) {
    model::Displacement pending;
    tip_ = path.back();
    on_path_ = {path.begin(), path.end()};
    std::sort(on_path_.begin(), on_path_.end());
    for (const std::size_t node : path) {
      const Segment segment = segment_of(node);
      pending = folded(pending, segment.before);
      if (segment.joint) {
        note_mimic(*segment.joint, robot.joints.size());
        robot.joints.push_back(joint_of(*segment.joint, robot));
        robot.joints.back().before = pending;
        // A link's frame is not turned behind its joint: such a turn belongs to what the link carries.
        const model::Displacement behind{segment.after.turns, {}};
        robot.joints.back().after.translation = segment.after.translation;
        robot.joints.back().inertia = inertia_of(lumped(node, behind, robot));
        context_->joint_places.push_back(segment.joint->place);
        pending = behind;
      } else {
        pending = folded(pending, segment.after);
      }
    }
    robot.tool = pending;
    tie_followers(*context_, names_, robot);
    if (!robot.joints.empty()) leave_out_partial_inertia(robot);
  }

 private:
  /// A last link without mass has no forward dynamics, and it is seldom that this is what was meant.
  void leave_out_partial_inertia(model::Robot& robot) const {
    const bool last_is_empty = is_empty(robot.joints.back());
    if (!last_is_empty || std::all_of(robot.joints.begin(), robot.joints.end(),
                                      [](const model::Joint& joint) { return is_empty(joint); }))
      return;
    context_->warning(context_->joint_places.back(),
                      "the last joint moves no mass, others do: the inertia of all is left out",
                      "give its link a mass, or none any");
    for (model::Joint& joint : robot.joints) joint.inertia = {};
  }

  static bool is_empty(const model::Joint& joint) {
    const auto is_zero = [](const model::Expression& e) { return e.is_literal_zero(); };
    return is_zero(joint.inertia.mass) && is_zero(joint.drive.rotor_inertia) &&
           std::all_of(joint.inertia.inertia.begin(), joint.inertia.inertia.end(), is_zero);
  }

  void note_mimic(const MovingJoint& joint, std::size_t index) {
    names_.push_back(joint.name);
    if (const auto& mimic = joint.mimic)
      context_->followers.push_back({index, mimic->leader, mimic->ratio, mimic->offset, mimic->place});
  }

  const Segment& segment_of(std::size_t node) {
    const auto [place, is_new] = segments_.try_emplace(node);
    if (is_new) place->second = (*read_)(node).value_or(Segment{});
    return place->second;
  }

  model::Joint joint_of(const MovingJoint& moving, const model::Robot& robot) const {
    std::vector<std::string> taken;
    for (const model::Joint& joint : robot.joints) taken.push_back(joint.variable);
    model::Joint joint;
    joint.type = moving.type;
    joint.variable = identifier(moving.name, taken);
    if (moving.is_named && joint.variable != moving.name)
      context_->note(moving.place, "the joint '" + moving.name + "' is '" + joint.variable + "' in the code",
                     "names have letters, digits and '_' there, at most 64, and are no macros");
    joint.axis = moving.axis;
    joint.limits = moving.limits;
    joint.greatest_velocity = moving.greatest_velocity;
    joint.greatest_effort = moving.greatest_effort;
    joint.drive = moving.drive;
    return joint;
  }

  /// The link, `placement` in the frame behind its joint, with all that is fixed to it, in that frame. The
  /// robot's last joint moves it and its frames.
  Body lumped(std::size_t link, const model::Displacement& placement, model::Robot& robot) {
    Body sum = moved(placement, segment_of(link).body);
    std::vector<std::pair<std::size_t, model::Displacement>> open{{link, placement}};
    while (!open.empty()) {
      const auto [node, frame] = open.back();
      open.pop_back();
      for (const std::size_t child : (*nodes_)[node].children) {
        if ((*nodes_)[child].moves) {
          note_branch(child);
        } else if (segments_.size() < 2 * most_links) {
          const Segment& segment = segment_of(child);
          const auto to_child = folded(folded(frame, segment.before), segment.after);
          name_frame(child, to_child, robot);
          if (!is_empty(segment.body)) sum = joined(sum, moved(to_child, segment.body));
          open.emplace_back(child, to_child);
        } else if (!crowded_) {
          crowded_ = true;
          context_->error((*nodes_)[child].place, "more than " + std::to_string(2 * most_links) + " links",
                          "an arm has fewer");
        }
      }
    }
    return sum;
  }

  /// The tip has its functions already.
  void name_frame(std::size_t node, const model::Displacement& placement, model::Robot& robot) const {
    const Node& named = (*nodes_)[node];
    if (node == tip_ || !named.has_name || robot.frames.size() == most_frames) return;
    const std::string name = frame_identifier(named.name, robot.frames);
    robot.frames.push_back({name, robot.joints.size() - 1, placement});
  }

  static bool is_empty(const Body& body) {
    return cln::zerop(body.mass) &&
           std::all_of(body.inertia.begin(), body.inertia.end(), [](const Vector& row) {
             return std::all_of(row.begin(), row.end(),
                                [](const cln::cl_R& entry) { return cln::zerop(entry); });
           });
  }

  void note_branch(std::size_t child) {
    if (std::binary_search(on_path_.begin(), on_path_.end(), child)) return;
    const Node& node = (*nodes_)[child];
    context_->note(node.place,
                   "'" + node.name + "' moves beside the chain: it and what it carries are left out",
                   "fix it if its mass is to count");
  }

  Context* context_;
  const std::vector<Node>* nodes_;
  const ReadSegment* read_;
  std::size_t tip_ = Node::none;
  std::vector<std::size_t> on_path_;
  std::vector<std::string> names_;  ///< of the chain's joints, in the file
  std::map<std::size_t, Segment> segments_;
  bool crowded_ = false;
};

}  // namespace

void read_chain(Context& context, const std::vector<Node>& nodes, Ends ends, const ReadSegment& read,
                model::Robot& robot) {
  const auto path = path_between(nodes, ends).value();
  const auto moving =
      std::count_if(path.begin(), path.end(), [&](std::size_t node) { return nodes[node].moves; });
  const std::string names = "from " + nodes[ends.base].name + " to " + nodes[ends.tip].name;
  if (moving == 0) {
    context.error(nodes[ends.tip].place, "no joint " + names + " moves", "choose another --base or --tip");
  } else if (moving > static_cast<long>(max_joints)) {
    context.error(nodes[ends.tip].place, std::to_string(moving) + " joints " + names + " move",
                  "a robot has at most " + std::to_string(max_joints) + " joints");
  } else if (path.size() > most_links) {
    context.error(nodes[ends.tip].place, std::to_string(path.size()) + " links " + names,
                  "an arm has at most " + std::to_string(most_links));
  } else {
    ChainReader(context, nodes, read).read(path, robot);
  }
}

}  // namespace qvgen::description::tree
