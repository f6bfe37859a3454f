// SPDX-License-Identifier: MIT
// The header of a mechanism with closed loops: assemblies for given joints, rates, Jacobians, dynamics by
// embedding, and the inverse kinematics of arms and legs that have loops.
#pragma once

#include <string>
#include <vector>

#include "derive/loops/assembly_plan.h"
#include "pipeline/language.h"
#include "pipeline/robot_output.h"
#include "verify/loops/mobility.h"

namespace qvgen::pipeline {

/// Each unknown of a plan with its equation, a line a step.
std::vector<std::string> step_lines(const model::Robot& described, const derive::inverse::Plan& plan);

/// Says why the driven joints and the outputs do not fit the freedoms: they are more or fewer, or the driven
/// ones leave others loose; empty if they fit.
std::string problem_of_motors(const model::Mechanism& mechanism, const verify::Mobility& mobility);

/// Outputs of the robots that a mechanism with loops calls.
struct PartsOfLoops {
  std::vector<RobotOutput> limbs;   ///< in the order of the tips
  std::vector<RobotOutput> chains;  ///< of loops in space, and the rests of these loops
};

/// Returns the robots that loops in space are solved by, with the part of each that is needed.
struct ChainRobot {
  model::Robot robot;
  std::string part;
};
std::vector<ChainRobot> chain_robots(const model::Mechanism& mechanism);

/// Adds `assembly.h` and its source, or in C `qvgen_ROBOT_loops.h` and its source, to the output of a robot
/// with loops, or what is missing of it. The functions of dynamics and of tips are there if the output has
/// what they call, the inverse kinematics of tips if their `limbs` have theirs. `with_c`: a header of C for
/// the C++, too.
void add_assembly(const model::Mechanism& mechanism, const PartsOfLoops& parts, Language language,
                  bool with_c, RobotOutput& output);

}  // namespace qvgen::pipeline
