// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace qvgen::test {

/// "pieper_007"
std::string pieper_name(std::uint32_t seed);

/// The description of a random arm of six joints, three consecutive of them revolute with axes through one point, at
/// any of the four places; the others any mix of turns and slides. Axes along coordinates or oblique with exact
/// rational components; numeric and symbolic offsets, or none.
std::string pieper_description(std::uint32_t seed);

}  // namespace qvgen::test
