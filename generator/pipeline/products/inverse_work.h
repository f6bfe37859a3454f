// SPDX-License-Identifier: MIT
// How much extra work poses near singular ones may take, for the code that bounds it and for its comments.
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/plan.h"
#include "derive/inverse/problem.h"

namespace qvgen::pipeline {

/// Joints and branches that Newton's steps polish, and how many passes, steps and instructions that is at
/// most.
nlohmann::json work_values(const derive::inverse::Problem& problem, const derive::inverse::Plan& plan);

}  // namespace qvgen::pipeline
