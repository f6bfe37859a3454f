// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "description/context.h"
#include "description/tree/rigid.h"
#include "model/mechanism.h"

/// Files that describe a tree of links, of which one path is the robot.
namespace qvgen::description::tree {

/// A motor that moves several joints, which follow it.
struct TendonMotor {
  std::string key;               ///< its name among leaders
  model::Motor motor;            ///< `variable`: its name in the file
  std::set<std::string> joints;  ///< that have to be there if others shall follow it
  Place place;
};

/// Motion of a joint by the values of others, which have their names in the file.
struct Mimic {
  model::Follows leaders;
  model::Expression offset;
  Place place;
  bool may_be_alone = false;             ///< the joint is free in a chain without its leaders
  std::vector<TendonMotor> motors = {};  ///< those of the leaders that are no joints
  model::Powers powers = {};             ///< of the only leader
};

struct MovingJoint {
  std::string name;
  bool is_named = true;  ///< the file has this name
  Place place;
  model::JointType type = model::JointType::revolute;
  model::Vector3 axis;  ///< unit vector
  std::optional<model::Limits> limits;
  std::optional<model::Expression> greatest_velocity = {}, greatest_effort = {};
  model::Drive drive;
  std::optional<Mimic> mimic = {};
};

/// A link with the joint that holds it: frame = parent's frame * before * motion * after.
struct Segment {
  model::Displacement before;
  std::optional<MovingJoint> joint;  ///< none: fixed
  model::Displacement after;
  Body body;  ///< in the link's frame
};

/// A link among others, before its numbers are read.
struct Node {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::string name;
  Place place;
  std::size_t parent = none;
  std::vector<std::size_t> children;
  bool moves = false;      ///< the joint that holds it has a variable
  bool is_marker = false;  ///< a point on a link: a tip only if it is asked for, or called like one
  std::string joint = {};  ///< the name of the joint that holds it, if it has one
  bool floats = false;     ///< that joint is of a kind that no chain has: a chain begins behind it
  bool is_free = false;    ///< that joint lets it move in all six ways
  bool has_name = true;    ///< the file gives it, not the reader
};

/// Reads the numbers of one link and its joint: only those that are needed, so that a gripper beside the
/// chain cannot spoil it. Nothing where that joint can be in no chain; it has been reported then.
using ReadSegment = std::function<std::optional<Segment>(std::size_t node)>;

/// Ties two links into a loop, by what both have in common where the file closes it.
struct Closure {
  model::LoopType type = model::LoopType::ball;
  std::array<std::size_t, 2> nodes{};
  std::array<model::Displacement, 2> frames;     ///< of what is common, seen from each node
  std::optional<model::Vector3> axis = {};       ///< seen from the first node
  model::Expression length = {};                 ///< of a rod, m
  std::optional<std::string> length_joint = {};  ///< the slide that says it, by its name in the file
  Place place;
};

/// Names of joints in a file.
struct JointNames {
  std::vector<std::string> names;
  Place place;
};

/// Loops of a file, whose numbers are read if the whole tree is meant.
struct Loops {
  bool any = false;
  std::function<std::vector<Closure>(const std::vector<Node>& nodes)> read = {};
  std::function<void()> leave_out = {};  ///< warns of loops that a chain has not
  JointNames actuated = {}, outputs = {};
  bool may_lack = false;  ///< joints with motors may be outside of what is read
};

/// True if options leave a file the loops that it has: no chain is meant.
bool takes_loops(const ReadOptions& options);

/// Reads the body of a link in its own frame, whatever joint holds it.
using ReadBody = std::function<Body(std::size_t node)>;

struct Ends {
  std::size_t base = Node::none;
  std::size_t tip = Node::none;
};

/// Beyond this many names a list helps nobody, and looking for the nearest one takes too long.
inline constexpr std::size_t many_names = 1000;

/// Returns the node of that name, which an option gives; reported if there is none.
std::optional<std::size_t> find_node(Context& context, const std::vector<Node>& nodes,
                                     const std::string& name, const std::string& option,
                                     const std::string& kind);
/// Returns the base that an option names, or the only root; reported if there is none.
std::optional<std::size_t> find_base(Context& context, const std::vector<Node>& nodes,
                                     const std::string& kind);

/// The base and tip that the options name, or the only ones that can be meant; reported if there are none.
/// `kind` is how the file calls its nodes: link, body.
std::optional<Ends> find_ends(Context& context, const std::vector<Node>& nodes, const std::string& kind);

/// The tip that is meant though no option names it; reported with a list of all limbs if there are several.
std::optional<std::size_t> likely_tip(Context& context, const std::vector<Node>& nodes, std::size_t base);

/// The nodes from the base (left out) to the tip; nothing if the tip does not hang on the base.
std::optional<std::vector<std::size_t>> path_between(const std::vector<Node>& nodes, Ends ends);

/// Fills in joints and tool: fixed links are folded into the frames, the masses of all that is fixed to a
/// moving link, on the path or beside it, are lumped. Each of those fixed links becomes a named frame.
void read_chain(Context& context, const std::vector<Node>& nodes, Ends ends, const ReadSegment& read,
                model::Robot& robot);

/// Reads the whole tree behind a base: the limbs to the tips that the options name, or to all. Links that no
/// limb needs are left out. Every fixed link becomes a named frame, but those of the base. With `read_body`
/// the base floats. Loops tie links of the tree together.
model::Mechanism read_mechanism(Context& context, const std::vector<Node>& nodes, std::size_t base,
                                const std::string& kind, const ReadSegment& read, const ReadBody& read_body,
                                const Loops& loops);

/// Reads what the options ask for: a chain, which has no tips then, or a whole tree; with joints held where
/// they say so. With loops it is the whole tree, unless they ask for a chain. `title` is what the file calls
/// the robot.
model::Mechanism read_tree(Context& context, const std::vector<Node>& nodes, const std::string& kind,
                           const std::string& title, const ReadSegment& read, const ReadBody& read_body,
                           const Loops& loops = {});

/// Returns a valid name of the generated code for a joint that a file calls by any text, different from those
/// that are taken.
std::string identifier(const std::string& text, const std::vector<std::string>& taken);
/// Likewise for a robot: in lower case.
std::string robot_identifier(const std::string& text);

}  // namespace qvgen::description::tree
