// SPDX-License-Identifier: MIT
// Closed loops in C99: the plans that assembly.cpp has in C++, by the printer and the blocks of the inverse
// kinematics in C, and the motion of all joints. Dynamics and tips call the robot's and its limbs' own C.
// Sines are those of the C library.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/loops/assembly_plan.h"
#include "emit/c/function.h"
#include "pipeline/loop_variants.h"

namespace qvgen::pipeline {

/// Returns the header and the source. `values`: those of the templates of C++. `first`: the plan whose
/// equations the gaps are.
emit::c::Part loops_in_c(const model::Mechanism& mechanism, const std::vector<PlannedVariant>& plans,
                         const derive::loops::AssemblyPlan& first, const nlohmann::json& values);

}  // namespace qvgen::pipeline
