// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "canonical/arm.h"

namespace qvgen::emit {

/// One line for each joint whose angle a derivation counts from another zero than the description; none for
/// most arms.
std::vector<std::string> legend(const canonical::Arm& arm);

}  // namespace qvgen::emit
