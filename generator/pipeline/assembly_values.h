// SPDX-License-Identifier: MIT
// Values of the templates of assembly.h: the loops' equations, and each way through the loops with its steps.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "derive/loops/assembly_plan.h"
#include "pipeline/assembly.h"

namespace qvgen::pipeline {

template <class List>
std::string commas(const List& list) {
  return fmt::format("{}", fmt::join(list, ", "));
}

/// Names of joints as the description has them, with commas.
std::string described_names(const model::Robot& robot, const std::vector<std::size_t>& joints);

/// Adds the equations that say how far loops are from being closed, with their derivatives by the joints.
void add_constraints(const derive::loops::AssemblyPlan& assembly, nlohmann::json& values);

/// Certifies a way through the loops, and returns its values. Throws where the certificate does not hold.
nlohmann::json variant_of(const model::Mechanism& mechanism, const LoopVariant& variant,
                          const derive::loops::AssemblyPlan& assembly);

}  // namespace qvgen::pipeline
