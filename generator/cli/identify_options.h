// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/identify_command.h"

namespace qvgen::cli {

/// Names of the kinds of drive parameters, in the order of derive::dynamics::DriveParameter.
const std::vector<std::string>& drive_names();

/// Adds the command; `robot` takes the name or file of the arm.
CLI::App* add_identify(CLI::App& app, std::string& robot, IdentifyArguments& arguments);

}  // namespace qvgen::cli
