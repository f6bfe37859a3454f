// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// A product: one header with its definitions and source for every robot (forward kinematics, dynamics, ...).
///
/// Adds its files and its counts to the robot's output, and what it could not make. `part` is the header's
/// name, included by the robot's umbrella header; `headers` are further ones that may be missing by
/// themselves, `functions` those that a header that is there may lack. `generate_c` adds the same as C, by
/// `add_c_part`.
struct Product {
  std::string part;
  void (*generate)(const model::Robot& robot, RobotOutput& output);
  std::vector<std::string> headers = {};
  std::vector<std::string> functions = {};
  void (*generate_c)(const model::Robot& robot, RobotOutput& output);
  bool on_request = false;              ///< made only for who names it
  std::vector<std::string> needs = {};  ///< products whose headers its header includes
  bool of_trees = false;  ///< made of robots whose joints branch, too; others are of their limbs
};

/// A part that is made only for who asks for it by its name, from what others have made of a robot.
struct Extra {
  std::string part;
  std::vector<std::string> needs;  ///< products
  /// Adds files, or what is missing.
  void (*add)(const model::Robot& robot, RobotOutput& output);
  bool of_trees = false;
  bool of_motors = false;  ///< made of robots whose joints follow motors, too
  bool in_c = false;       ///< made of a robot's C alone; others of its C++
};
const std::vector<Extra>& all_extras();

/// All products, in the order of the umbrella header.
const std::vector<Product>& all_products();

}  // namespace qvgen::pipeline
