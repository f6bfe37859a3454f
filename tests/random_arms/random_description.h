// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace qvgen::test {

/// The description of a random arm of one to eight joints: turns and slides mixed; axes along coordinates, at
/// 30, 45 and 60 degrees, at decimals in radians, along diagonals; offsets that are zero, numbers, symbols,
/// quotients and roots of symbols; base and tool turned by decimals or not; as joints, as a
/// Denavit-Hartenberg table (standard and modified) or as screws.
std::string random_description(std::uint32_t seed);

/// Writes the random description with inertias on every link.
std::string random_description_with_inertia(std::uint32_t seed);
/// Chains of two to six joints with inertia, of which some follow others.
std::string random_description_with_followers(std::uint32_t seed);

/// Chains of two to six joints with inertia that follow motors, by invertible rational matrices: pairs by
/// sums and differences, others by a motor and joints or motors before it. Motors have drives of their own.
std::string random_description_with_motors(std::uint32_t seed);

}  // namespace qvgen::test
