// SPDX-License-Identifier: MIT
// Assemblies of closed loops in C99: the plans that assembly.cpp has in C++, by the printer and the blocks of
// the inverse kinematics in C. Sines are those of the C library.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/loops/assembly_plan.h"
#include "pipeline/loop_variants.h"

namespace qvgen::pipeline {

/// Returns the source of all functions that assemble, and of the gaps; nothing if a step has no block in C.
/// `values`: those of the templates of C++. `first`: the plan whose equations the gaps are.
std::string assemblies_in_c(const model::Mechanism& mechanism, const std::vector<PlannedVariant>& plans,
                            const derive::loops::AssemblyPlan& first, const nlohmann::json& values);

}  // namespace qvgen::pipeline
