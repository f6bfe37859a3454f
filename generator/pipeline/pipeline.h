// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// The parts (headers of a robot: kinematics, jacobian, ...) that a run generates; none named means all.
using Parts = std::vector<std::string>;

/// description -> model -> symbolic -> derive -> dag -> passes -> emit, for one robot.
RobotOutput generate_robot(const model::Robot& robot, const Parts& parts = {});

/// All files of a run, robots in parallel: theirs, operation_counts.json and the folder's README. Robots that
/// `earlier` (the operation_counts.json in place, if any) knows and this run does not keep their entries.
/// `missing` receives "robot: reason" for what could not be derived.
std::vector<OutputFile> generate(const std::vector<model::Robot>& robots, const Parts& parts,
                                 const nlohmann::ordered_json& earlier,
                                 const std::function<void(const std::string& robot)>& progress = {},
                                 std::vector<std::string>* missing = nullptr);

}  // namespace qvgen::pipeline
