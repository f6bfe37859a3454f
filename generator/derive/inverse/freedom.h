// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/attempt.h"

namespace qvgen::derive::inverse {

/// Empty if the velocities of these joints are independent at an ordinary place: six of them move the tool in
/// every way, three its point. Otherwise why no pose has finitely many solutions: a set of isolated ones
/// would not be the truth.
std::string dependent_joints(const Attempt& attempt, const std::vector<std::size_t>& joints,
                             bool position_only);

/// Names the dependent joints of an arm of four that is asked for a pitch, which all but the first change by
/// their turns: empty if they move the tool point and the pitch in every way at an ordinary place.
std::string dependent_joints_of_pitch(const Attempt& attempt);

/// Names the dependent joints of an arm that is asked for an inclination, which the first joint does not
/// change: empty if the others move the tool point and incline the tool in every way at an ordinary place.
std::string dependent_joints_of_inclination(const Attempt& attempt);

/// Names the dependent joints of five that keep the tool level: empty if the first three of them move a point
/// on the last axis in every way at an ordinary place.
std::string dependent_joints_of_level(const Attempt& attempt);

/// Names the dependent joints of an arm whose joint k of four has a `point` on its axis that the three others
/// place.
std::string dependent_joints_about(const Attempt& attempt, std::size_t k, const symbolic::Vector& point);

}  // namespace qvgen::derive::inverse
