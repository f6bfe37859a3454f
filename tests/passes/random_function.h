// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dag/graph.h"

namespace qvgen::test {

/// A random function over a few symbols and angles: sums, products, squares, shared parts, constants,
/// quotients.
dag::Function random_function(std::uint32_t seed, int operations);

}  // namespace qvgen::test
