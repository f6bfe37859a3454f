// SPDX-License-Identifier: MIT
// The page of a robot whose joints branch: drawn as a whole, its tips (and a base that floats) to be dragged,
// with which joint carries which, and a way to the page of each limb.
#pragma once

#include <string>
#include <vector>

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::report {

struct WholeRobot {
  std::string name, title;
  std::vector<std::string> tree;    ///< lines that say which joint carries which
  std::vector<model::Robot> limbs;  ///< each has a page of its own
  bool floats = false;              ///< the base moves freely
};

/// Returns the page NAME.html, a single file, and the robot's entry of the common pages.
pipeline::RobotOutput whole_page(const WholeRobot& robot);

}  // namespace qvgen::report
