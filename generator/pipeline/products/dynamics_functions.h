// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"
#include "optimise/optimise.h"
#include "pipeline/robot_output.h"

/// Shared parts of the headers of functions of dynamics: measuring, counting and writing them.
namespace qvgen::pipeline {

/// Returns a function's entry in operation_counts.json.
nlohmann::ordered_json entry_of(const model::Robot& robot, const optimise::Optimised& function);

/// Measures the function's rounding error, if the description has numbers for all that it needs.
void measure(const model::Robot& robot, optimise::Optimised& function);

/// Puts functions in terms of the joints that follow none, as the code has them.
optimise::Optimised in_terms_of_leaders(const model::Robot& robot, optimise::Optimised function);
std::vector<optimise::Optimised> in_terms_of_leaders(const model::Robot& robot,
                                                     std::vector<optimise::Optimised> functions);

/// Adds a header of several functions that share sines and cosines, with its definitions and source. `values`
/// are further values of its templates.
void add_functions(const model::Robot& robot, const std::vector<optimise::Optimised>& functions,
                   const std::string& part, const std::string& angles_type, nlohmann::json values,
                   RobotOutput& output);

/// Adds a header of a single function, which is measured and put in terms of the leaders here.
void add_function(const model::Robot& robot, optimise::Optimised function, const std::string& part,
                  const std::string& angles_type, const std::vector<dag::Angle>& angles,
                  nlohmann::json values, RobotOutput& output);

}  // namespace qvgen::pipeline
