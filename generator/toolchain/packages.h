// SPDX-License-Identifier: MIT
// ROS packages found by their names, without ROS: `$(find NAME)` and `package://NAME/...` mean the folder of
// a package. A package is a folder with a package.xml, which says its name, or a folder of that name directly
// inside one that is searched.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace qvgen::toolchain {

using Packages = std::map<std::string, std::filesystem::path>;

/// Returns the packages in these folders, and in those around a file that names some; the first of a name
/// counts. Folders may be joined by colons as in ROS_PACKAGE_PATH.
Packages packages_in(const std::vector<std::string>& folders, const std::filesystem::path& file);

/// Returns the path that `package://NAME/REST` means, or an empty one if there is no such package; other
/// paths are returned as they are.
std::filesystem::path without_package(const std::string& path, const Packages& packages);

}  // namespace qvgen::toolchain
