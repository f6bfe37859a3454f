// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "model/robot.h"

/// A second, plain opinion on what a model means, in doubles and homogeneous matrices; it shares no code with
/// the model's own evaluation.
namespace qvgen::test {

using Values = std::map<std::string, double>;

double value(const model::Expression& expression, const Values& values);
Values default_values(const model::Robot& robot);
Eigen::Isometry3d displacement(const model::Displacement& displacement, const Values& values);
/// World to tool at the joint variables q.
Eigen::Isometry3d tool_pose(const model::Robot& robot, const std::vector<double>& q, const Values& values);
/// World to the frame of each link.
std::vector<Eigen::Isometry3d> link_frames(const model::Robot& robot, const std::vector<double>& q,
                                           const Values& values);

/// Reads a file of generator/robots; the test fails if it has any mistake.
model::Robot robot_named(const std::string& name);

}  // namespace qvgen::test
