// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace qvgen::test {

/// Arms with five joints as they are built, without names and titles.
inline constexpr std::array<const char*, 1> five_arms{
    // Three parallel axes behind a first one across them (link lengths of the youBot's arm). With the tool
    // point on the first axis that is free, and the links follow for few of its angles.
    R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.147, a = 0.033, alpha = "90 deg" },
      { theta = "q2", variable = "q2", a = 0.155 },
      { theta = "q3", variable = "q3", a = 0.135 },
      { theta = "q4 + 90 deg", variable = "q4", alpha = "90 deg" },
      { theta = "q5", variable = "q5", d = 0.2175 }]
)toml"};

}  // namespace qvgen::test
