// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace qvgen::test {

/// "pieper_007", "parallel_007", "slides_001"
std::string arm_name(const std::string& family, std::uint32_t seed);

/// Writes an arm of a family: "pieper" or "parallel", one of these cut to "five" or "four" joints, one of the
/// sixteen "codes" cut to two to five, or the arm of that number in sliding_arms.h, twisted_arms.h,
/// other_zeros.h, sliding_machines.h, seven_arms.h, pitched_arms.h or unstructured_arms.h; behind these four
/// random arms of the kind follow.
std::string arm_description(const std::string& family, std::uint32_t seed);

/// The description of a random arm of six joints, three consecutive of them revolute with axes through one
/// point, at any of the four places; the others any mix of turns and slides. Axes along coordinates or
/// oblique with exact rational components; numeric and symbolic offsets, or none.
std::string pieper_description(std::uint32_t seed);

/// The description of a random arm of six revolute joints, three consecutive of them with parallel axes that
/// do not coincide, at any of the four places; of the others some are skew, some parallel, and some meet
/// their neighbour. Some are written as link tables with twists that are symbols.
std::string parallel_description(std::uint32_t seed);

}  // namespace qvgen::test
