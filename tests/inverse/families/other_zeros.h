// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace qvgen::test {

/// Arms as people write them: zeros of the joints at odd angles, frames turned by decimals, twists in plain
/// radians, lengths that are roots and quotients. All behind `name` and `title`.
inline constexpr std::array<const char*, 8> other_zeros{
    // Offsets of the second and third joint that cancel, as an arm with a bent upper arm has them.
    R"toml(convention = "standard"
[[dh]]
theta = "theta1"
variable = "theta1"
d = 0.267
alpha = "-90 deg"
[[dh]]
theta = "theta2 - 79.35 deg"
variable = "theta2"
a = 0.28949
[[dh]]
theta = "theta3 + 79.35 deg"
variable = "theta3"
a = 0.0775
alpha = "-90 deg"
[[dh]]
theta = "theta4"
variable = "theta4"
d = 0.3425
alpha = "90 deg"
[[dh]]
theta = "theta5"
variable = "theta5"
alpha = "-90 deg"
[[dh]]
theta = "theta6"
variable = "theta6"
d = 0.097
)toml",
    // Base and tool turned by decimals, the wrist's zero by a right angle.
    R"toml([base]
translation = [0.1, "sqrt(2)/10", 0.3]
rpy = ["30 deg", "-45 deg", "100 deg"]
[tool]
translation = [0.1, 0, 0.05]
rpy = ["10 deg", 0.2, 0.3]
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta2"
origin = [0.32, 0, 0.78]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta3"
origin = [0, 0, 1.075]
[[joint]]
type = "revolute"
axis = "+x"
variable = "theta4"
origin = [1.1425, 0, 0.2]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta5"
rpy = [0, "90 deg", 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta6"
link = [0, 0, 0.2]
)toml",
    // Three parallel axes, base and tool turned by decimals.
    R"toml(convention = "standard"
[base]
rpy = [0.1, 0.2, 0.3]
[tool]
translation = [0.1, 0, 0.05]
rpy = ["10 deg", "20 deg", 0.3]
[[dh]]
theta = "theta1"
variable = "theta1"
d = 0.1273
alpha = "90 deg"
[[dh]]
theta = "theta2 + 0.7"
variable = "theta2"
a = -0.612
[[dh]]
theta = "theta3 - 1.1"
variable = "theta3"
a = -0.5723
[[dh]]
theta = "theta4"
variable = "theta4"
d = 0.163941
alpha = "90 deg"
[[dh]]
theta = "theta5"
variable = "theta5"
d = 0.1157
alpha = "-90 deg"
[[dh]]
theta = "theta6"
variable = "theta6"
d = 0.0922
)toml",
    // Right angles in five digits: the wrist is a little oblique, and stays so.
    R"toml(convention = "standard"
[[dh]]
theta = "theta1"
variable = "theta1"
d = 0.4
alpha = "-1.5708"
[[dh]]
theta = "theta2"
variable = "theta2"
a = 0.4
[[dh]]
theta = "theta3"
variable = "theta3"
a = 0.1
alpha = "-1.5708"
[[dh]]
theta = "theta4"
variable = "theta4"
d = 0.4
alpha = "1.5708"
[[dh]]
theta = "theta5"
variable = "theta5"
alpha = "-1.5708"
[[dh]]
theta = "theta6"
variable = "theta6"
d = 0.1
)toml",
    // Lengths that are quotients and roots of symbols.
    R"toml([defaults]
l1 = 0.4
l2 = 0.3
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
origin = [0, 0, "l1/l2"]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta2"
link = [0, 0, "sqrt(l1^2 + l2^2)"]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta3"
link = ["0.3*cos(10 deg)", 0, "sqrt(3)/10"]
[[joint]]
type = "revolute"
axis = "+x"
variable = "theta4"
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta5"
[[joint]]
type = "revolute"
axis = "+x"
variable = "theta6"
link = [0.1, 0, 0]
)toml",
    // A wrist between axes at 55 degrees, behind a shoulder whose second axis lies along a diagonal.
    R"toml([[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
link = [0, 0, 0.3]
[[joint]]
type = "revolute"
axis = ["1/sqrt(3)", "1/sqrt(3)", "1/sqrt(3)"]
variable = "theta2"
link = [0.3, 0, 0.1]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta3"
link = [0.2, 0, 0.4]
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta4"
[[joint]]
type = "revolute"
axis = "+z"
rpy = ["55 deg", 0, 0]
variable = "theta5"
[[joint]]
type = "revolute"
axis = "+z"
rpy = ["-55 deg", 0, 0]
variable = "theta6"
link = [0, 0, 0.1]
)toml",
    // A general shoulder behind a spherical wrist at the base.
    R"toml(convention = "standard"
[[dh]]
theta = "theta1"
variable = "theta1"
alpha = "90 deg"
[[dh]]
theta = "theta2"
variable = "theta2"
alpha = "-90 deg"
[[dh]]
theta = "theta3"
variable = "theta3"
d = 0.4
a = 0.1
alpha = "40 deg"
[[dh]]
theta = "theta4"
variable = "theta4"
d = 0.4
a = 0.3
alpha = "-65 deg"
[[dh]]
theta = "theta5"
variable = "theta5"
d = 0.1
a = 0.2
alpha = "50 deg"
[[dh]]
theta = "theta6"
variable = "theta6"
d = 0.1
)toml",
    // Frames turned by symbols, and lengths whose names an own value of a derivation could have.
    R"toml([defaults]
t0 = 0.4
t1 = 0.3
turn = 0.7
[base]
translation = ["t0/7", 0, 0]
rpy = ["turn/3", 0, "turn"]
[tool]
translation = [0, 0, "t1^2"]
rpy = [0, "turn/5", 0]
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
link = ["t0/3", 0, 0.2]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta2"
link = ["t1", 0, "t0"]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta3"
link = ["t0 + t1", 0.05, 0.28]
[[joint]]
type = "revolute"
axis = "+x"
variable = "theta4"
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta5"
[[joint]]
type = "revolute"
axis = "+x"
variable = "theta6"
link = [0.1, 0, 0]
)toml"};

}  // namespace qvgen::test
