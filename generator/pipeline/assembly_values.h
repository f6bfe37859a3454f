// SPDX-License-Identifier: MIT
// Values that the templates of closed loops take: equations of the loops, and one way to assemble them.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "derive/loops/assembly_plan.h"
#include "pipeline/loop_variants.h"

namespace qvgen::pipeline {

template <class List>
std::string commas(const List& list) {
  return fmt::format("{}", fmt::join(list, ", "));
}

/// Names of joints, as the description has them.
std::string described_names(const model::Robot& robot, const std::vector<std::size_t>& joints);

/// The most assemblies that a plan gives: a number, times that of each chain, by its name between two texts.
std::string capacity_of(const derive::loops::AssemblyPlan& assembly, const std::string& before,
                        const std::string& behind);

/// Adds the gaps, their Jacobian and its rate as code.
void add_constraints(const derive::loops::AssemblyPlan& assembly, nlohmann::json& values);

/// Returns the values of one function that assembles, which is certified on the way.
nlohmann::json variant_of(const model::Mechanism& mechanism, const LoopVariant& variant,
                          const derive::loops::AssemblyPlan& assembly);

/// Returns these values with code in C, whose names begin with the function's.
nlohmann::json variant_in_c(const LoopVariant& variant, const derive::loops::AssemblyPlan& assembly,
                            nlohmann::json values);
/// Puts the gaps, their Jacobian and its rate in C in the place of those in C++.
void add_constraints_in_c(const derive::loops::AssemblyPlan& assembly, nlohmann::json& values);

}  // namespace qvgen::pipeline
