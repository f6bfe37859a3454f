// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "emit/cpp/jacobian_function.h"
#include "emit/math/singularities.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Measures that vanish at singular configurations, and the function that computes them.
struct MeasuresFunction {
  emit::SingularityMeasures measures;
  emit::JacobianFunction function;
};

/// None, and the reason in the output, if they cannot be had.
MeasuresFunction singularity_measures_function(const model::Robot& robot, RobotOutput& output);

/// `jacobian`.
emit::JacobianFunction plain_jacobian_function(const model::Robot& robot);

/// All other functions of jacobian.h but the measures', in its order.
std::vector<emit::JacobianFunction> further_jacobian_functions(const model::Robot& robot);

}  // namespace qvgen::pipeline
