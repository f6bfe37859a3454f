// SPDX-License-Identifier: MIT
#pragma once

#include "dag/graph.h"

namespace qvgen::emit {

/// The same outputs as people write them: sums of products with what their terms have in common taken out
/// (sines and cosines first), products of sines and cosines that are one of a sum of angles as that, and
/// a - a sin^2 as a cos^2. What is no sum of products stays as it is within its term.
dag::Function collected(dag::Function function);

}  // namespace qvgen::emit
