// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "built_arms.h"

namespace qvgen::test {

/// Arms as they are built that are asked for a position and a pitch, without names and titles.
inline constexpr std::array<BuiltArm, 6> pitched_arms{
    {// A desk arm of five servos with lateral offsets: pan, three pitches, roll.
     {"tool_axis = \"+x\"\ngiven = \"roll\"\n", desk_arm},
     // The youBot's arm: no lateral offset, the tool point on the first axis frees that joint.
     {"given = \"q5\"\n", youbot_arm},
     // Four servos straight up at zero, pitches that turn the other way, the tool point on the first axis
     // there.
     {R"toml(tool_axis = "+z"
joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, 0, "h"] },
         { type = "revolute", axis = "-x", variable = "q2", link = [0, 0, "l2"] },
         { type = "revolute", axis = "+x", variable = "q3", link = [0, 0, "l3"] },
         { type = "revolute", axis = "-x", variable = "q4", link = [0, 0, "l4"] }]
[defaults]
h = 0.1
l2 = 0.2
l3 = 0.15
l4 = 0.08
)toml"},
     // A column that lifts an arm that extends; the gripper's camera, off the roll's axis, is what is
     // inclined.
     {R"toml(tool_axis = ["3/5", 0, "4/5"]
given = "q5"
joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, 0.05, 0.3] },
         { type = "revolute", axis = "+y", variable = "q2" },
         { type = "prismatic", axis = "+x", variable = "q3", link = [0.1, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q4", link = [0.1, 0, 0] },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.05, 0.03, 0.02] }]
)toml"},
     // On a rail, whose value is given, between frames turned by decimals.
     {R"toml(given = "q1"
joint = [{ type = "prismatic", axis = "+y", variable = "q1" },
         { type = "revolute", axis = "+z", variable = "q2", link = [0.05, 0, 0.3] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.3, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q4", link = [0.25, 0.02, 0] },
         { type = "revolute", axis = "+y", variable = "q5", link = [0.1, 0, 0] }]
)toml",
      "", turned_frames},
     // The first axis leans, so that the arm moves on a cone.
     {R"toml(tool_axis = "+x"
joint = [{ type = "revolute", axis = [0, "3/5", "4/5"], variable = "q1", link = [0.05, 0.04, 0.3] },
         { type = "revolute", axis = "+y", variable = "q2", link = [0.3, 0, 0] },
         { type = "prismatic", axis = ["4/5", 0, "-3/5"], variable = "q3" },
         { type = "revolute", axis = "-y", variable = "q4", link = [0.2, 0.1, 0] }]
)toml"}}};

}  // namespace qvgen::test
