// SPDX-License-Identifier: MIT
// Parts that both programs of paths share: the functions that an arm has, and a run with a file of poses.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "path/poses.h"
#include "programs/program.h"

namespace qvgen::path {

/// Name that those of all inverse kinematics begin with.
inline constexpr const char* plain = "inverse_kinematics";

/// Returns the names of an arm's inverse kinematics that take whole poses.
std::vector<std::string> functions_of(const pipeline::RobotOutput& output);

/// Runs a program with the poses as its first argument and these words behind; returns its JSON. Throws
/// std::runtime_error if it fails.
nlohmann::ordered_json run_with_poses(const programs::Program& program, const std::vector<std::string>& words,
                                      const Poses& poses);

}  // namespace qvgen::path
