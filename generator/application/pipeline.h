// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// description -> model -> symbolic -> derive -> dag -> passes -> emit, for one robot.
RobotOutput generate_robot(const model::Robot& robot);

/// All files of a run, robots in parallel: theirs, operation_counts.json and the folder's README. Robots that `earlier`
/// (the operation_counts.json in place, if any) knows and this run does not keep their entries.
std::vector<OutputFile> generate(const std::vector<model::Robot>& robots, const nlohmann::ordered_json& earlier,
                                 const std::function<void(const std::string& robot)>& progress = {});

}  // namespace qvgen::application
