// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::description {

/// Returns a model of one body with these geoms; `head`: what stands in front of the world.
inline std::string body(const std::string& geoms, const std::string& head = "") {
  return "<mujoco>" + head + "<worldbody>\n<body name=\"b\"><joint/>" + geoms +
         "</body></worldbody></mujoco>";
}

}  // namespace qvgen::description
