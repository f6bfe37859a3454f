// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace qvgen::pipeline {

/// Why no inverse kinematics was found, without what repeats itself: one line for a structure that no three
/// joints in a row have, and one for what holds whichever joint is given. `joints`: of the arm.
std::vector<std::string> brief_reasons(const std::vector<std::string>& reasons, std::size_t joints);

}  // namespace qvgen::pipeline
