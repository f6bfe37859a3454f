// SPDX-License-Identifier: MIT
#pragma once

#include "dag/graph.h"

namespace qvgen::emit {

/// Rewrites outputs as people write them: common factors of a sum's terms are taken out (sines and cosines
/// first), products of sines and cosines become sines or cosines of sums of angles, and a - a sin^2 becomes a
/// cos^2. Other terms stay unchanged.
dag::Function collected(dag::Function function);

}  // namespace qvgen::emit
