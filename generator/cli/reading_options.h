// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include "description/reader.h"

namespace qvgen::cli {

/// Adds the options of every command that reads a description.
void add_reading(CLI::App& command, description::ReadOptions& options);

/// Adds the option of commands that take a whole tree of links.
void add_tips(CLI::App& command, description::ReadOptions& options);

}  // namespace qvgen::cli
