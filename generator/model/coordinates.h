// SPDX-License-Identifier: MIT
// The coordinates of a robot's motion: six of a floating base, if there is one, then the joints that follow
// none. Velocities, accelerations, forces and the rows of mass matrices are in this order.
#pragma once

#include <string>
#include <vector>

#include "model/robot.h"

namespace qvgen::model {

/// Motions of a rigid body: along x, y and z, then about them.
inline constexpr std::size_t motions_of_body = 6;

/// Returns how many coordinates the base has: six if it floats, else none.
std::size_t base_motions(const Robot& robot);

/// Symbol of a motion of a floating base in its own frame at its origin, 0 to 5; no description can have it.
std::string base_coordinate(std::size_t motion);

/// Returns how many bodies have inertia parameters: the links, behind a floating base. Link j is the body
/// j + base_bodies.
std::size_t base_bodies(const Robot& robot);
std::size_t body_count(const Robot& robot);

/// Returns the symbols of all coordinates.
std::vector<std::string> coordinates(const Robot& robot);
std::size_t coordinate_count(const Robot& robot);

}  // namespace qvgen::model
