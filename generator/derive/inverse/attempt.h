// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "derive/inverse/builder.h"
#include "derive/inverse/target.h"

namespace qvgen::derive::inverse {

/// One attempt at a plan: a fresh scope, so that what a failed attempt has named is gone.
struct Attempt {
  explicit Attempt(const model::Robot& from)
      : robot(from), scope(robot), chain(chain_of(robot, scope, plan.target)), builder(robot, scope, plan) {}
  const model::Robot& robot;
  Scope scope;
  Plan plan;
  Chain chain;
  Builder builder;
};

/// "2, 3 and 4" for the joints first, first + 1, ... (counted from 0).
std::string joint_range(std::size_t first, std::size_t count);

/// The point that two axes share; nothing if they are parallel or miss each other.
std::optional<symbolic::Vector> meeting_point(const Screw& a, const Screw& b, const Scope& scope);

// Each of these fills in the attempt's plan and returns an empty text, or why the structure does not serve.

/// Joints k, k+1, k+2 meet in a point: the others carry it, then the three turn about it. `locked` is the
/// joint whose value the caller gives, -1 for none.
std::string by_common_point(Attempt& attempt, std::size_t k, int locked = -1);
/// Three joints and a point: the orientation is not asked for.
std::string by_position(Attempt& attempt);
/// Parallel revolute joints in a plane: two of them with a position, three with an orientation too; with
/// `locked` the last of three is given and the position alone is asked for.
std::string in_plane(Attempt& attempt, bool locked);
/// Six revolute joints, k, k+1, k+2 parallel: directions and heights along their axes hold the angles of two
/// others.
std::string by_parallel_axes(Attempt& attempt, std::size_t k);

/// The coordinates of a vector across a screw's axis.
Flat in_frame(const Screw& screw, const symbolic::Vector& v, const Scope& scope);

/// e_a e_b start = goal in the plane of two parallel axes.
void two_link(Attempt& attempt, const Screw& a, const Screw& b, const symbolic::Vector& start,
              const symbolic::Vector& goal);

}  // namespace qvgen::derive::inverse
