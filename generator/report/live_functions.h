// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/robot.h"
#include "pipeline/robot_output.h"
#include "report/webassembly.h"
#include "toolchain/generated.h"

namespace qvgen::report {

/// The inverse kinematics of poses, and the joint whose value it is given; empty where there is none.
struct InverseCall {
  std::string function;
  std::string given;
};
InverseCall inverse_call(const pipeline::RobotOutput& output);

/// Functions that a page calls besides the robot's C functions: those that are generated in C++ alone.
struct CppFunctions {
  Compiled module;
  InverseCall inverse;  ///< by elimination
  bool has_arm_angle = false;

  [[nodiscard]] bool wanted() const { return has_arm_angle || !inverse.function.empty(); }
};

/// Returns the C++ functions of a robot whose C functions have, or lack, all solutions of a pose. Without a
/// runtime nothing is compiled and the module says so.
CppFunctions cpp_functions(const model::Robot& robot, bool has_inverse_in_c,
                           const toolchain::Runtime* runtime);

}  // namespace qvgen::report
