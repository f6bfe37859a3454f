// SPDX-License-Identifier: MIT
// Macros of URDFs: xacro, a program of ROS that PyPI has too, writes the URDF that a file with macros means.
// Without ROS it cannot resolve $(find PACKAGE); here it is told where packages are.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "toolchain/process.h"

namespace qvgen::toolchain {

/// The command that installs xacro, for messages.
inline constexpr const char* install_xacro = "pip install xacro";

/// True if a text has macros, or values that xacro fills in.
bool uses_xacro(std::string_view text);

/// Runs the machine's xacro on a file and returns the URDF, or what xacro says is wrong. Arguments are
/// `name:=value`; packages are looked for in the folders, in those of ROS_PACKAGE_PATH and around the file.
/// `files`: where to put the paths of the files that it includes, if they are wanted.
Outcome run_xacro(const std::filesystem::path& file, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& package_folders, std::vector<std::string>* files = nullptr);

}  // namespace qvgen::toolchain
