// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "derive/inverse/builder.h"
#include "derive/inverse/problem.h"
#include "derive/inverse/target.h"

namespace qvgen::derive::inverse {

/// One attempt at a plan: a fresh scope, so that what a failed attempt has named is gone.
struct Attempt {
  /// `problem` outlives the attempt.
  explicit Attempt(const Problem& from)
      : problem(from),
        robot(from.robot),
        scope(robot, from.given_slides ? "" : held_parameter(from)),
        chain(chain_of(robot, scope, plan.target)),
        builder(robot, scope, plan) {}

  /// "2, 3 and 4" for the joints first, first + 1, ... (counted from 0), by their numbers in the arm.
  [[nodiscard]] std::string joints(std::size_t first, std::size_t count) const;

  const Problem& problem;
  const model::Robot& robot;
  Scope scope;
  Plan plan;
  Chain chain;
  Builder builder;
};

/// The point that two axes share; nothing if they are parallel or miss each other.
std::optional<symbolic::Vector> meeting_point(const Screw& a, const Screw& b, const Scope& scope);

// Each of these fills in the attempt's plan and returns an empty text, or why the structure does not serve.

/// Joints k, k+1, k+2 meet in a point: the others carry it, then the three turn about it. With four joints
/// the rows are candidates, as below.
std::string by_common_point(Attempt& attempt, std::size_t k);
/// Four joints: the others carry a point on the axis of joint k, then that turns about it. The rows are
/// candidates, for four joints do not follow every pose.
std::string by_single_turn(Attempt& attempt, std::size_t k);
/// Three revolute joints and an orientation: the position is not asked for.
std::string by_orientation(Attempt& attempt);
/// Three joints and a point: the orientation is not asked for.
std::string by_position(Attempt& attempt);
/// Four joints and a pitch: the first turns the others, which move in one plane, the last of them a turn.
std::string by_pitch(Attempt& attempt);
/// Five joints and an inclination: as by_pitch, and a last joint that rolls the tool.
std::string by_inclination(Attempt& attempt);
/// Five joints that keep the tool level: as by_pitch with the pitch that the description has at zero, and a
/// last joint about the direction of the first.
std::string by_level(Attempt& attempt);
/// Parallel revolute joints in a plane: two of them with a position, three with an orientation too.
std::string in_plane(Attempt& attempt);
/// Six revolute joints, k, k+1, k+2 parallel: directions and heights along their axes hold the angles of two
/// others.
std::string by_parallel_axes(Attempt& attempt, std::size_t k);
/// Six joints, three of them slides: the others turn the tool, then the slides are linear equations.
std::string by_three_slides(Attempt& attempt);
/// Four joints, two of them slides: the others turn the tool, then the slides are linear equations. The rows
/// are candidates, as above.
std::string by_two_slides(Attempt& attempt);

/// All joints, three or one, but joint k and those after it up to `count` bring a point on the axes of these
/// to where the pose has it.
std::string place_centre(Attempt& attempt, Target& target, std::size_t k, std::size_t count,
                         const symbolic::Vector& centre);

/// Newton steps of all joints towards the whole pose: three points that stand off from each other by the size
/// of the arm are carried to where the pose has them.
void polish_pose(Attempt& attempt, const Target& target);

/// The coordinates of a vector across a screw's axis.
Flat in_frame(const Screw& screw, const symbolic::Vector& v, const Scope& scope);

/// e_a e_b start = goal in the plane of two parallel axes.
void two_link(Attempt& attempt, const Screw& a, const Screw& b, const symbolic::Vector& start,
              const symbolic::Vector& goal);

}  // namespace qvgen::derive::inverse
