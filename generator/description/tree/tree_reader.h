// SPDX-License-Identifier: MIT
// The joints of a tree of links, parents first. Fixed links are folded into the frames, and what is fixed to
// a moving link becomes part of its mass. A chain is the tree whose links are one path.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/tree/tree.h"

namespace qvgen::description::tree {

class TreeReader {
 public:
  /// `tip`: the node that is no named frame, or none.
  TreeReader(Context& context, const std::vector<Node>& nodes, const ReadSegment& read, std::size_t tip)
      : context_(&context), nodes_(&nodes), read_(&read), tip_(tip) {}

  /// Fills in the joints that hold these nodes, each of which stands behind its parent. Their first parent is
  /// the base.
  void read(const std::vector<std::size_t>& order, model::Robot& robot);
  /// Ties followers to their leaders, or returns their relations, for loops, among which motors become
  /// joints.
  void tie(model::Robot& robot);
  std::vector<model::Gear> gears(model::Robot& robot);

  /// Returns the inertia of the base with all that is fixed to it, in its own frame. `order`: as `read` has
  /// it.
  model::Inertia read_base(std::size_t base, const Body& own, const std::vector<std::size_t>& order);

  /// Returns the joint that moves a node that was read, and the node's frame in that joint's link frame.
  [[nodiscard]] model::Frame place_of(std::size_t node) const;
  /// Likewise for a node that may only be fixed to one that was read; nothing for others.
  [[nodiscard]] std::optional<model::Frame> find_place(std::size_t node);
  /// Returns the index of a joint by its name in the file; nothing if it was not read.
  [[nodiscard]] std::optional<std::size_t> joint_called(const std::string& name) const;

 private:
  /// Place of a node: moved by a joint, its frame displaced from that joint's link frame.
  struct Standing {
    std::size_t joint = model::base_link;
    model::Displacement frame;
  };

  void read_node(std::size_t node, model::Robot& robot);
  void add_joint(const Segment& segment, const Standing& before, model::Robot& robot);
  model::Joint joint_of(const MovingJoint& moving, const model::Robot& robot) const;
  void note_mimic(const MovingJoint& joint, std::size_t index);
  using Rubs = std::function<bool(const std::string& joint)>;
  void take_motors(model::Robot& robot, const Rubs& rubs);
  [[nodiscard]] bool rubs(const std::string& name, const model::Robot& robot) const;
  [[nodiscard]] std::string obstacle_of_motors(const Follower& follower, const Rubs& rubs) const;
  void free_from_motors(const Rubs& rubs);
  void add_motor(const TendonMotor& motor, model::Robot& robot);
  void check_ends(model::Robot& robot) const;
  void leave_out_partial_inertia(model::Robot& robot) const;

  const Segment& segment_of(std::size_t node);
  Body lumped(std::size_t link, const Body& own, const model::Displacement& placement, model::Robot* robot);
  void name_frame(std::size_t node, const model::Displacement& placement, model::Robot& robot) const;
  void note_branch(std::size_t child);

  Context* context_;
  const std::vector<Node>* nodes_;
  const ReadSegment* read_;
  std::size_t tip_;
  std::map<std::size_t, Standing> standing_;
  std::vector<std::size_t> read_nodes_;                     ///< sorted
  std::vector<std::string> names_;                          ///< of the joints, in the file
  std::map<std::size_t, std::vector<TendonMotor>> motors_;  ///< by the joints that follow them
  std::map<std::string, std::string> motor_variables_;      ///< by the motors' keys
  std::map<std::size_t, Segment> segments_;
  bool crowded_ = false;
};

/// More links in a row, or fixed to one another, than any robot has; each costs a few microseconds.
inline constexpr std::size_t most_links = 1000;

}  // namespace qvgen::description::tree
