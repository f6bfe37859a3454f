// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/robot.h"

namespace qvgen::derive::inverse {

/// The axes of the tool whose direction may be asked for: the one that the request names, or all, z first,
/// along which most tools point.
std::vector<model::Vector3> tool_axes(const model::InverseRequest& request);

/// The joints that may be given, by their indices, what is most often the best first: a rail carries an arm
/// of its own, an elbow turns about the line between the shoulder and the wrist.
std::vector<std::size_t> given_joints(const model::Robot& robot);

/// The joints that may be given, from the tool to the base: a roll changes no direction of its own axis.
std::vector<std::size_t> given_from_the_tool(const model::Robot& robot);

}  // namespace qvgen::derive::inverse
