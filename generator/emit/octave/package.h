// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/unit.h"

namespace qvgen::emit::octave {

/// Files of a package folder, by their paths inside it: a file a function, `model.m` with the constants, and
/// all functions of the robot's C as one MEX file, which `build.m` compiles. `files` are the C itself;
/// `missing` are lines on what it has not.
std::vector<std::pair<std::string, std::string>> package(const blocks::Unit& unit,
                                                         const std::vector<blocks::File>& files,
                                                         const std::vector<std::string>& missing);

}  // namespace qvgen::emit::octave
