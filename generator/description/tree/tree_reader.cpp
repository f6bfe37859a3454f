// SPDX-License-Identifier: MIT
#include "description/tree/tree_reader.h"

#include <algorithm>

#include "description/followers.h"
#include "description/named_frames.h"
#include "model/arithmetic.h"
#include "model/mechanism.h"

namespace qvgen::description::tree {
namespace {

bool is_empty(const model::Joint& joint) {
  const auto is_zero = [](const model::Expression& e) { return e.is_literal_zero(); };
  return is_zero(joint.inertia.mass) && is_zero(joint.drive.rotor_inertia) &&
         std::all_of(joint.inertia.inertia.begin(), joint.inertia.inertia.end(), is_zero);
}

bool is_empty(const Body& body) {
  return cln::zerop(body.mass) &&
         std::all_of(body.inertia.begin(), body.inertia.end(), [](const Vector& row) {
           return std::all_of(row.begin(), row.end(),
                              [](const cln::cl_R& entry) { return cln::zerop(entry); });
         });
}

}  // namespace

void TreeReader::read(const std::vector<std::size_t>& order, model::Robot& robot) {
  read_nodes_ = order;
  std::sort(read_nodes_.begin(), read_nodes_.end());
  if (!order.empty()) standing_[(*nodes_)[order.front()].parent] = {};
  for (const std::size_t node : order) read_node(node, robot);
  if (!robot.joints.empty()) check_ends(robot);
}

void TreeReader::tie(model::Robot& robot) {
  take_motors(robot, [&](const std::string& joint) { return rubs(joint, robot); });
  tie_followers(*context_, names_, robot);
}

std::vector<model::Gear> TreeReader::gears(model::Robot& robot) {
  take_motors(robot, [](const std::string& /*joint*/) { return false; });
  const std::size_t joints = robot.joints.size();
  make_motors_joints(*context_, robot);
  for (std::size_t i = joints; i < robot.joints.size(); ++i) names_.push_back(robot.joints[i].variable);
  return gears_of(*context_, names_, robot);
}

model::Inertia TreeReader::read_base(std::size_t base, const Body& own,
                                     const std::vector<std::size_t>& order) {
  read_nodes_ = order;
  std::sort(read_nodes_.begin(), read_nodes_.end());
  return inertia_of(lumped(base, own, {}, nullptr));
}

model::Frame TreeReader::place_of(std::size_t node) const {
  const Standing& standing = standing_.at(node);
  return {(*nodes_)[node].name, standing.joint, standing.frame};
}

std::optional<model::Frame> TreeReader::find_place(std::size_t node) {
  std::vector<std::size_t> fixed;
  while (standing_.count(node) == 0) {
    if ((*nodes_)[node].moves || (*nodes_)[node].parent == Node::none) return std::nullopt;
    fixed.push_back(node);
    node = (*nodes_)[node].parent;
  }
  model::Frame place = place_of(node);
  for (; !fixed.empty(); fixed.pop_back()) {
    const Segment& segment = segment_of(fixed.back());
    place.placement = folded(folded(place.placement, segment.before), segment.after);
  }
  return place;
}

std::optional<std::size_t> TreeReader::joint_called(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names_.begin());
}

void TreeReader::read_node(std::size_t node, model::Robot& robot) {
  const Segment segment = segment_of(node);
  Standing standing = standing_.at((*nodes_)[node].parent);
  standing.frame = folded(standing.frame, segment.before);
  if (segment.joint) {
    add_joint(segment, standing, robot);
    // A link's frame is not turned behind its joint: such a turn belongs to what the link carries.
    standing = {robot.joints.size() - 1, {segment.after.turns, {}}};
    robot.joints.back().inertia = inertia_of(lumped(node, segment_of(node).body, standing.frame, &robot));
  } else {
    standing.frame = folded(standing.frame, segment.after);
  }
  standing_[node] = standing;
}

void TreeReader::add_joint(const Segment& segment, const Standing& before, model::Robot& robot) {
  note_mimic(*segment.joint, robot.joints.size());
  robot.joints.push_back(joint_of(*segment.joint, robot));
  robot.joints.back().before = before.frame;
  robot.joints.back().after.translation = segment.after.translation;
  model::set_parent(robot, robot.joints.size() - 1, before.joint);
  context_->joint_places.push_back(segment.joint->place);
}

void TreeReader::note_mimic(const MovingJoint& joint, std::size_t index) {
  names_.push_back(joint.name);
  if (const auto& mimic = joint.mimic)
    context_->followers.push_back(
        {index, mimic->leaders, mimic->offset, mimic->place, mimic->may_be_alone, mimic->powers});
  if (joint.mimic && !joint.mimic->motors.empty()) motors_[index] = joint.mimic->motors;
}

/// Adds a motor under a name of its own.
void TreeReader::add_motor(const TendonMotor& motor, model::Robot& robot) {
  if (motor_variables_.count(motor.key) > 0) return;
  std::vector<std::string> taken;
  for (const model::Joint& joint : robot.joints) taken.push_back(joint.variable);
  for (const model::Motor& other : robot.motors) taken.push_back(other.variable);
  robot.motors.push_back(motor.motor);
  robot.motors.back().variable = motor_variables_[motor.key] = identifier(motor.motor.variable, taken);
  context_->motor_places.push_back(motor.place);
}

/// True if a joint would follow several and has Coulomb friction, whose direction is no sum of theirs.
bool TreeReader::rubs(const std::string& name, const model::Robot& robot) const {
  const auto joint = joint_called(name);
  return joint && !robot.joints[*joint].drive.coulomb_friction.is_literal_zero() &&
         std::any_of(context_->followers.begin(), context_->followers.end(), [&](const Follower& follower) {
           return follower.joint == *joint && follower.leaders.size() > 1;
         });
}

/// Returns why a joint cannot follow its motors, empty if it can or has none.
std::string TreeReader::obstacle_of_motors(const Follower& follower, const Rubs& rubs) const {
  const auto motors = motors_.find(follower.joint);
  if (motors == motors_.end()) return "";
  std::set<std::string> joints{names_[follower.joint]};
  for (const TendonMotor& motor : motors->second) joints.insert(motor.joints.begin(), motor.joints.end());
  for (const std::string& joint : joints) {
    if (!joint_called(joint)) return "'" + joint + "', which they move too, is not among the joints";
    if (rubs(joint)) return "'" + joint + "' would follow several and has Coulomb friction";
  }
  return "";
}

/// Frees the joints that cannot follow their motors, with a warning.
void TreeReader::free_from_motors(const Rubs& rubs) {
  std::vector<Follower> kept;
  for (const Follower& follower : context_->followers) {
    const std::string obstacle = obstacle_of_motors(follower, rubs);
    if (obstacle.empty())
      kept.push_back(follower);
    else
      context_->warning(follower.place,
                        "the motors of '" + names_[follower.joint] + "' act by tendons, but " + obstacle +
                            ": it has a value of its own",
                        "with all of these joints, without 'frictionloss', it has the motors' values");
  }
  context_->followers = std::move(kept);
}

/// Adds the motors that joints follow.
void TreeReader::take_motors(model::Robot& robot, const Rubs& rubs) {
  if (motors_.empty()) return;
  free_from_motors(rubs);
  for (Follower& follower : context_->followers) {
    if (const auto motors = motors_.find(follower.joint); motors != motors_.end())
      for (const TendonMotor& motor : motors->second) add_motor(motor, robot);
    for (model::Lead& lead : follower.leaders)
      if (const auto known = motor_variables_.find(lead.variable); known != motor_variables_.end())
        lead.variable = known->second;
  }
}

const Segment& TreeReader::segment_of(std::size_t node) {
  const auto [place, is_new] = segments_.try_emplace(node);
  if (is_new) place->second = (*read_)(node).value_or(Segment{});
  return place->second;
}

model::Joint TreeReader::joint_of(const MovingJoint& moving, const model::Robot& robot) const {
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

/// The link with its own body, `placement` in the frame behind its joint, with all that is fixed to it, in
/// that frame. The robot's last joint moves it and its frames; none: they have no names.
Body TreeReader::lumped(std::size_t link, const Body& own, const model::Displacement& placement,
                        model::Robot* robot) {
  Body sum = moved(placement, own);
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
        if (robot != nullptr) name_frame(child, to_child, *robot);
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
void TreeReader::name_frame(std::size_t node, const model::Displacement& placement,
                            model::Robot& robot) const {
  const Node& named = (*nodes_)[node];
  if (node == tip_ || !named.has_name || robot.frames.size() == most_frames) return;
  const std::string name = frame_identifier(named.name, robot.frames);
  robot.frames.push_back({name, robot.joints.size() - 1, placement});
}

void TreeReader::note_branch(std::size_t child) {
  if (std::binary_search(read_nodes_.begin(), read_nodes_.end(), child)) return;
  const Node& node = (*nodes_)[child];
  context_->note(node.place,
                 "'" + node.name + "' moves beside the chain: it and what it carries are left out",
                 "fix it if its mass is to count");
}

/// Last links without mass have no forward dynamics, and it is seldom that this is what was meant.
void TreeReader::check_ends(model::Robot& robot) const {
  if (!model::branches(robot)) return leave_out_partial_inertia(robot);
  std::vector<bool> carries(robot.joints.size(), false);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (const std::size_t parent = model::parent_of(robot, i); parent != model::base_link)
      carries[parent] = true;
  if (std::all_of(robot.joints.begin(), robot.joints.end(),
                  [](const model::Joint& joint) { return is_empty(joint); }))
    return;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (!carries[i] && is_empty(robot.joints[i]))
      context_->warning(context_->joint_places[i],
                        "the joint '" + names_[i] + "' moves no mass: there is no forward dynamics",
                        "give its link a mass, or hold the joint: --fixed " + names_[i]);
}

void TreeReader::leave_out_partial_inertia(model::Robot& robot) const {
  const bool last_is_empty = is_empty(robot.joints.back());
  if (!last_is_empty || std::all_of(robot.joints.begin(), robot.joints.end(),
                                    [](const model::Joint& joint) { return is_empty(joint); }))
    return;
  context_->warning(context_->joint_places.back(),
                    "the last joint moves no mass, others do: the inertia of all is left out",
                    "give its link a mass, or none any");
  for (model::Joint& joint : robot.joints) joint.inertia = {};
}

}  // namespace qvgen::description::tree
