// SPDX-License-Identifier: MIT
// Ways through closed loops: each function of `assembly.h` that finds assemblies, with the joints whose
// values it takes. Motors lead to all joints, a platform's joints lead back, and the joints of a limb lead to
// the rest: an inverse kinematics of the limb goes on through them to the motors.
#pragma once

#include <string>
#include <vector>

#include "derive/loops/assembly_plan.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// A function with its given joints and the names of what belongs to it in code.
struct LoopVariant {
  std::string function;
  std::vector<std::size_t> given;
  std::string type;      ///< of its set of assemblies
  std::string space;     ///< namespace of its steps
  std::string argument;  ///< values of the given joints
  bool of_limb = false;  ///< takes the joints of a limb
};

/// Returns the ways from the driven joints, and from those of a platform, if there is one.
std::vector<LoopVariant> loop_variants(const model::Loops& loops);
/// Returns the ways from the joints of each limb, but for those whose joints another way takes already.
std::vector<LoopVariant> limb_variants(const model::Mechanism& mechanism);

/// A way with its plan.
struct PlannedVariant {
  LoopVariant variant;
  derive::loops::AssemblyPlan assembly;
};

/// Says how the inverse kinematics of one tip goes on through the loops.
struct LimbInverse {
  std::string function;    ///< finds the assemblies for the limb's joints; empty if there is none
  std::string type;        ///< of its set
  std::string lack;        ///< why there is none; empty if none is asked for
  std::string space = {};  ///< of the function's details
  bool has_gears = false;  ///< joints follow others there
};

/// True if a robot has an inverse kinematics that takes poses.
bool solves_poses(const RobotOutput& robot);

/// Finds the way on from an arm's solutions to the motors. `limb` is the output of the limb to that tip.
LimbInverse limb_inverse(const model::Mechanism& mechanism, std::size_t tip, const RobotOutput& limb,
                         const std::vector<PlannedVariant>& plans);

}  // namespace qvgen::pipeline
