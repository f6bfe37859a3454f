// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace qvgen::test {

/// Three slides, machine tools and gantries: their other joints turn the tool. All behind `name` and `title`.
inline constexpr std::array<const char*, 6> sliding_machines{
    // A machine tool, both turns at the head, the tool off their axes.
    R"toml([[joint]]
type = "prismatic"
axis = "+x"
variable = "q1"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "q2"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q3"
[[joint]]
type = "revolute"
axis = "+z"
variable = "q4"
link = [0.05, 0, -0.1]
[[joint]]
type = "revolute"
axis = "+x"
variable = "q5"
link = [0.03, 0.04, -0.2]
)toml",
    // Both turns at the table: the tool as the workpiece sees it.
    R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "q1"
origin = [0, 0, 0.1]
link = [0, 0.02, 0.05]
[[joint]]
type = "revolute"
axis = "+x"
variable = "q2"
link = [0.1, 0, 0.05]
[[joint]]
type = "prismatic"
axis = "+x"
variable = "q3"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "q4"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q5"
origin = [0, 0, 0.3]
)toml",
    // One turn at the table, one at the head, about an axis halfway between two directions.
    R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "q1"
link = [0, 0.02, 0.1]
[[joint]]
type = "prismatic"
axis = "+x"
variable = "q2"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "q3"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q4"
[[joint]]
type = "revolute"
axis = [0, "sqrt(2)/2", "sqrt(2)/2"]
variable = "q5"
link = [0.03, 0.04, -0.2]
)toml",
    // A gantry with a hand whose axes miss each other.
    R"toml([defaults]
l1 = 0.05
l2 = 0.2
[[joint]]
type = "prismatic"
axis = "+x"
variable = "q1"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "q2"
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q3"
[[joint]]
type = "revolute"
axis = "+z"
variable = "q4"
link = ["l1", 0, -0.1]
[[joint]]
type = "revolute"
axis = "+y"
variable = "q5"
link = [0.03, 0.04, "-l2"]
[[joint]]
type = "revolute"
axis = "+z"
variable = "q6"
link = [0, 0.02, 0.1]
)toml",
    // No axis along another one, turns between all slides.
    R"toml([[joint]]
type = "prismatic"
axis = "+z"
variable = "q1"
origin = [0.1, 0.05, 0.2]
[[joint]]
type = "revolute"
axis = ["3/5", 0, "4/5"]
variable = "q2"
link = [0.2, 0.1, 0]
[[joint]]
type = "prismatic"
axis = "+y"
rpy = ["20 deg", "43 deg", "-31 deg"]
variable = "q3"
[[joint]]
type = "revolute"
axis = "+z"
variable = "q4"
link = [0.1, 0.1, 0.1]
[[joint]]
type = "prismatic"
axis = ["2/3", "-1/3", "2/3"]
rpy = ["56 deg", 0, "17 deg"]
variable = "q5"
[[joint]]
type = "revolute"
axis = "+x"
variable = "q6"
link = [0, 0.02, 0.1]
)toml",
    // Turns between all slides, at right angles: at some poses two slides are parallel, or all three in a
    // plane.
    R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "q1"
link = [0.1, 0.05, 0.2]
[[joint]]
type = "prismatic"
axis = "+x"
variable = "q2"
[[joint]]
type = "revolute"
axis = "+y"
variable = "q3"
link = [0.3, 0, 0]
[[joint]]
type = "prismatic"
axis = "+z"
variable = "q4"
origin = [0.1, 0.1, 0.1]
[[joint]]
type = "revolute"
axis = "+z"
variable = "q5"
link = [0.03, 0.04, -0.2]
[[joint]]
type = "prismatic"
axis = "+x"
variable = "q6"
)toml",
};

}  // namespace qvgen::test
