// SPDX-License-Identifier: MIT
// The header of a mechanism with closed loops: assemblies for given joints, rates, Jacobians, dynamics by
// embedding.
#pragma once

#include <string>
#include <vector>

#include "derive/loops/assembly_plan.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// A way through the loops: from which joints, under which name.
struct LoopVariant {
  std::string function;
  std::vector<std::size_t> given;
};
/// From the driven joints; and from those of a platform, if there is one.
std::vector<LoopVariant> loop_variants(const model::Loops& loops);

/// Each unknown of a plan with its equation, a line a step.
std::vector<std::string> step_lines(const model::Robot& described, const derive::inverse::Plan& plan);

/// Says why the numbers of driven joints and of outputs do not fit so many freedoms; empty if they do.
std::string problem_of_motors(const model::Mechanism& mechanism, int freedoms);

/// Adds `assembly.h` and its source to the output of a robot with loops, or what is missing of it. The
/// functions of dynamics and of tips are there if the output has what they call. `with_c`: a header for C,
/// too.
void add_assembly(const model::Mechanism& mechanism, bool with_c, RobotOutput& output);

}  // namespace qvgen::pipeline
