// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "built_arms.h"

namespace qvgen::test {

/// Arms of six joints as they are built that are asked for a position and a direction, one joint given: which
/// one, and the description without name and title.
struct DirectedArm {
  int given;
  BuiltArm arm;
};

inline constexpr std::array<DirectedArm, 6> directed_arms{
    {// A spherical wrist; the last joint turns about the tool's axis, so that its value does not matter.
     {5, "tool_axis = \"+z\"\n", wrist_arm},
     // A torch across the flange of such an arm; the base is given.
     {0, "tool_axis = [\"3/5\", 0, \"4/5\"]\ngiven = \"q1\"\n", wrist_arm,
      "[tool]\ntranslation = [0.05, 0.02, 0.1]\n"},
     // Three parallel axes (link lengths of the UR5), the wrist's second joint given.
     {4, R"toml(given = "q5"
convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.089159, alpha = "90 deg" },
      { theta = "q2", variable = "q2", a = -0.425 },
      { theta = "q3", variable = "q3", a = -0.39225 },
      { theta = "q4", variable = "q4", d = 0.10915, alpha = "90 deg" },
      { theta = "q5", variable = "q5", d = 0.09465, alpha = "-90 deg" },
      { theta = "q6", variable = "q6", d = 0.0823 }]
)toml"},
     // Five servos on a rail, whose value is given, between frames turned by decimals; the camera off the
     // roll.
     {0, R"toml(tool_axis = "+z"
given = "q1"
joint = [{ type = "prismatic", axis = "+y", variable = "q1" },
         { type = "revolute", axis = "+z", variable = "q2", link = [0.05, 0, 0.3] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.3, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q4", link = [0.25, 0.02, 0] },
         { type = "revolute", axis = "+y", variable = "q5", link = [0.1, 0, 0] },
         { type = "revolute", axis = "+x", variable = "q6", link = [0.05, 0, 0] }]
)toml",
      "", turned_frames},
     // A slide in the middle, given, in symbols.
     {2, R"toml(tool_axis = "+x"
given = "q3"
joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, "d2", 0.4] },
         { type = "revolute", axis = "-y", variable = "q2" },
         { type = "prismatic", axis = "+z", variable = "q3" },
         { type = "revolute", axis = "+z", variable = "q4" },
         { type = "revolute", axis = "-y", variable = "q5" },
         { type = "revolute", axis = "+z", variable = "q6", link = [0.05, 0, "l6"] }]
[defaults]
d2 = 0.15
l6 = 0.1
)toml"},
     // No structure: by elimination.
     {3, R"toml(tool_axis = "+y"
given = "q4"
joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0.1, 0.05, 0.4] },
         { type = "revolute", axis = "+y", variable = "q2", link = [0.5, 0.1, 0.05] },
         { type = "revolute", axis = "+x", variable = "q3", link = [0.3, 0.07, 0.1] },
         { type = "revolute", axis = "+z", variable = "q4", link = [0.1, 0.2, 0.06] },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.08, 0.05, 0.1] },
         { type = "revolute", axis = "+y", variable = "q6", link = [0.05, 0.02, 0.09] }]
)toml"}}};

}  // namespace qvgen::test
