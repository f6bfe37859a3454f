// SPDX-License-Identifier: MIT
// The way back of a constant displacement, for chains that are gone through from their ends.
#pragma once

#include "model/robot.h"

namespace qvgen::model {

/// Returns the displacement that leads back: its turns in reverse, and the translation as the end sees it.
Displacement inverse(const Displacement& displacement);

}  // namespace qvgen::model
