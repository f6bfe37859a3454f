// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace qvgen::test {

/// Arms without structure as they are built, without names and titles.
inline constexpr std::array<const char*, 2> unstructured_arms{
    // Seven joints no three of whose axes meet or are parallel (link lengths of the Sawyer arm); which one is
    // given is left to the generator.
    R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.317, a = 0.081, alpha = "-90 deg" },
      { theta = "q2", variable = "q2", d = 0.1925, alpha = "90 deg" },
      { theta = "q3", variable = "q3", d = 0.4, alpha = "-90 deg" },
      { theta = "q4", variable = "q4", d = -0.1685, alpha = "90 deg" },
      { theta = "q5", variable = "q5", d = 0.4, alpha = "-90 deg" },
      { theta = "q6", variable = "q6", d = 0.1363, alpha = "90 deg" },
      { theta = "q7", variable = "q7", d = 0.13375 }]
)toml",
    // A column on a rail that carries an arm with an offset hand.
    R"toml([[joint]]
type = "prismatic"
axis = "+x"
variable = "q1"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q2"
[[joint]]
type = "revolute"
axis = "+z"
variable = "q3"
link = [0.3, 0, 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "q4"
link = [0.25, 0, -0.1]
[[joint]]
type = "revolute"
axis = "+y"
variable = "q5"
link = [0.03, 0.04, -0.2]
[[joint]]
type = "revolute"
axis = "+x"
variable = "q6"
link = [0, 0.02, 0.1]
)toml"};

}  // namespace qvgen::test
