// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace qvgen::test {

/// "pieper_007", "parallel_007", "slides_001"
std::string arm_name(const std::string& family, std::uint32_t seed);

/// Writes an arm of a family. "pieper": a random arm of six joints, three consecutive of them revolute with
/// axes through one point, at any of the four places; the others any mix of turns and slides, axes along
/// coordinates or oblique with exact rational components, numeric and symbolic offsets, or none. "parallel":
/// six revolute joints, three consecutive of them with parallel axes that do not coincide; of the others some
/// are skew, some parallel, and some meet their neighbour; some are link tables with twists that are symbols.
/// "five", "four": one of these cut; "codes": one of the sixteen codes cut to two to five joints. Else the
/// arm of that number in the family's header (sliding_arms.h, twisted_arms.h, other_zeros.h,
/// sliding_machines.h, seven_arms.h, pitched_arms.h, inclined_arms.h, heading_arms.h, unstructured_arms.h);
/// behind those of the last six random arms follow.
std::string arm_description(const std::string& family, std::uint32_t seed);

}  // namespace qvgen::test
