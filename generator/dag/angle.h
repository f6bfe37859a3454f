// SPDX-License-Identifier: MIT
#pragma once

#include "exact/angle.h"

namespace qvgen::dag {
using exact::Angle;
}  // namespace qvgen::dag
