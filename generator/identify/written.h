// SPDX-License-Identifier: MIT
// The identified numbers as text: the description that was read, with new inertias and drives and all else as
// it was, comments included.
#pragma once

#include <string>

#include <Eigen/Core>

#include "description/reader.h"
#include "identify/arm_regressor.h"
#include "model/robot.h"

namespace qvgen::identify {

/// Returns the robot with numbers for its inertias and drives; `values` as in FullSet.
model::Robot with_values(model::Robot robot, const Eigen::VectorXd& values);

/// Returns a description in TOML with the numbers in place of those that its joints had. `text` is the file
/// that the robot was read from; a URDF or MJCF becomes TOML. `head`: lines of a comment for the file's
/// begin. Constant forces of the drives stand in comments. Throws std::runtime_error where the joints of a
/// file are written in a way that cannot be changed line by line.
std::string written(const std::string& text, const model::Robot& robot, const Eigen::VectorXd& values,
                    const std::string& head);

/// Returns the URDF `text`, all else as it was, with new inertias and frictions on the way from base to tip.
/// Links that are fixed to others lose their inertias, which are part of those. Rotor inertias and constant
/// forces, which no URDF takes, stand in comments behind the lines of `head`. Throws std::runtime_error for
/// text that is no URDF.
std::string written_urdf(const std::string& text, const description::ReadOptions& options,
                         const Eigen::VectorXd& values, const std::string& head);

}  // namespace qvgen::identify
