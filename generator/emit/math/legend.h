// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "canonical/arm.h"

namespace qvgen::emit {

/// One line for each joint that has another name in a derivation than in the description, or whose angle is
/// counted from another zero there; none for most arms. Behind the described joints `arm` may have virtual
/// ones.
std::vector<std::string> legend(const model::Robot& described, const canonical::Arm& arm);

}  // namespace qvgen::emit
