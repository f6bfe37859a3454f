// SPDX-License-Identifier: MIT
// Code of a platform on six rods from their lengths: a table of its complex places at the start of paths, and
// the function that follows them. It is in C++ alone.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/loop_variants.h"

namespace qvgen::pipeline {

bool is_on_six_rods(const model::Mechanism& mechanism);

/// Says how many places a platform on six rods has, and how they were found; empty for other mechanisms.
/// Throws std::domain_error if they cannot be counted.
std::string text_of_places(const model::Mechanism& mechanism);

/// Returns the values of `assemble` for such a platform; null for other mechanisms. `tips`: values of all
/// tips, of which the platform's needs an inverse kinematics. Throws std::domain_error with what is missing.
nlohmann::json six_rods_variant(const model::Mechanism& mechanism, const LoopVariant& variant,
                                const nlohmann::json& tips);

}  // namespace qvgen::pipeline
