// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace qvgen::test {

/// The description of a random arm: one to seven joints of either type; axes along coordinates, rational
/// obliques such as (3/5, 0, 4/5), constant rotations by multiples of 30 degrees, symbolic and numeric
/// offsets, or a Denavit-Hartenberg table.
std::string random_description(std::uint32_t seed);

}  // namespace qvgen::test
