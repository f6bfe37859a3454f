// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/identify_command.h"

namespace qvgen::cli {

/// Adds the command; `robot` takes the name or file of the arm.
CLI::App* add_identify(CLI::App& app, std::string& robot, IdentifyArguments& arguments);

}  // namespace qvgen::cli
