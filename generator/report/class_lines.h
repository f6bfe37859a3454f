// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/robot.h"

namespace qvgen::report {

/// The class of an arm, derived from its first three joints: code, whether it is useful and distinct,
/// workspace; and what the thesis prints of an arm of its name if that is something else. Empty where there
/// is no class: fewer joints, or a twist that is a symbol.
std::vector<std::string> class_lines(const model::Robot& robot);

}  // namespace qvgen::report
