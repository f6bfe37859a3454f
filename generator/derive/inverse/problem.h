// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "canonical/arm.h"
#include "model/robot.h"

/// Arms that a pose does not determine, or that cannot follow one, made into arms that it does.
///
/// A task that leaves motions of the tool open is the whole pose of an arm which makes these motions by
/// virtual joints at its tool: with a turn about the tool's axis behind five joints, "position and direction"
/// is a pose of six. A joint whose value the caller gives is a constant displacement by a parameter. What is
/// derived then knows nothing of tasks.
namespace qvgen::derive::inverse {

/// Part of a pose that the rows of a plan may still miss, so that it is checked.
enum class Filter { none, position, pose };

/// Joints whose turns add up to nothing, so that they move what is behind them without turning it. With all
/// joints of the described arm at zero the sum is zero.
struct Balance {
  std::vector<std::pair<int, int>> turns;  ///< places in a row, and 1 or -1: the sense of its axis

  [[nodiscard]] bool empty() const { return turns.empty(); }
};

struct Problem {
  model::Robot robot;  ///< the arm that the plan is of
  model::Task task = model::Task::pose;
  std::vector<int>
      places;  ///< by its joints: where in a row a value stands, virtual joints behind the arm's own
  int row_size = 0;
  int own_joints = 0;  ///< of the arm, the given one among them
  int given = -1;      ///< the arm's joint whose value the caller gives
  bool given_slides = false;
  int heading = -1;  ///< the joint about whose axis the heading turns, by its place, if it is the given one
  Filter filter = Filter::none;
  model::Vector3 tool_axis;  ///< of the tool's frame, for tasks with a direction
  Balance balance;           ///< of the joints that a plan keeps balanced

  // Relation of the described arm to `robot`, if that has canonical frames.
  model::Robot described;  ///< the arm as it is described, virtual joints behind its tool
  model::Robot moving;     ///< `robot` with the given joint moving
  model::Displacement base,
      tool;  ///< oblique frames, which cost one product with a pose: `robot` has base^-1 pose tool^-1
  bool has_frames = false;
  std::vector<exact::Angle> phases;  ///< by places in a row: its values are those described plus these

  [[nodiscard]] bool has_phases() const;
  /// True if the heading that the task leaves is a virtual joint.
  [[nodiscard]] bool has_heading() const;
  /// Returns the joint about whose axis a heading turns, by its place in a row: the first of those that are
  /// solved for that turns, or the given one.
  [[nodiscard]] int heading_joint() const;
};

/// The arm itself.
Problem problem_of(const model::Robot& robot, model::Task task);
/// The arm with one more joint, about or along a direction of the tool's frame, through the tool point.
Problem with_turn(const Problem& problem, const model::Vector3& axis);
Problem with_slide(const Problem& problem, const model::Vector3& axis);
/// The arm with the turn that an inclination leaves as one more joint, through the tool point. Its axis comes
/// with the pose: here it is the tool's z.
Problem with_heading(const Problem& problem);
/// The arm in other frames, those in front of its first joint and behind the last taken off where they are
/// oblique. Before a joint is held.
Problem of_canonical_arm(const Problem& problem, const canonical::Arm& arm);
/// Returns a joint's motion by a value.
model::Displacement motion_by(const model::Joint& joint, const model::Expression& value);
/// The arm with a joint held; its variable is a parameter of the geometry.
Problem with_held(const Problem& problem, std::size_t joint);

/// The parameter that stands for a held joint, empty if there is none.
std::string held_parameter(const Problem& problem);

}  // namespace qvgen::derive::inverse
