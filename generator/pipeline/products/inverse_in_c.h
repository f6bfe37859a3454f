// SPDX-License-Identifier: MIT
// Public functions of inverse kinematics in C: those of the arm itself, or functions in motors or of several
// given joints, which call those of an arm in joints or of an inner arm.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "model/robot.h"
#include "pipeline/products/inverse_outer.h"

namespace qvgen::pipeline {

/// Adds heads and names of public functions, and what stands between them and the arm that is solved, to the
/// values of the templates of C.
void add_public_functions_in_c(const model::Robot& described, const std::optional<OuterJoints>& outer,
                               nlohmann::json& values);

}  // namespace qvgen::pipeline
