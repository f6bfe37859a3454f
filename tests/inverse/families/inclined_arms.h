// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "built_arms.h"

namespace qvgen::test {

/// Arms as they are built that are asked for a position and an inclination, without names and titles.
inline constexpr std::array<BuiltArm, 6> inclined_arms{
    {// A desk arm of five servos with lateral offsets: pan, three pitches, roll.
     {desk_arm},
     // The youBot's arm: no lateral offset, the tool point on the first axis frees that joint.
     {youbot_arm},
     // A camera off the roll's axis, lengths by name, a pitch that turns the other way.
     {R"toml(joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, 0, "h"] },
         { type = "revolute", axis = "-x", variable = "q2", link = [0, 0, "l2"] },
         { type = "revolute", axis = "+x", variable = "q3", link = [0, 0, "l3"] },
         { type = "revolute", axis = "-x", variable = "q4", link = [0, 0, "l4"] },
         { type = "revolute", axis = "+z", variable = "q5", link = [0.03, 0.02, 0.05] }]
[defaults]
h = 0.1
l2 = 0.2
l3 = 0.15
l4 = 0.08
)toml"},
     // A column that lifts an arm that extends; the roll's axis leans in its hand.
     {R"toml(joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, 0.05, 0.3] },
         { type = "revolute", axis = "+y", variable = "q2" },
         { type = "prismatic", axis = "+x", variable = "q3", link = [0.1, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q4", link = [0.1, 0, 0] },
         { type = "revolute", axis = ["12/13", "5/13", 0], variable = "q5", link = [0.05, 0.03, 0.02] }]
)toml"},
     // On a rail, whose value is given, between frames turned by decimals.
     {R"toml(given = "q1"
joint = [{ type = "prismatic", axis = "+y", variable = "q1" },
         { type = "revolute", axis = "+z", variable = "q2", link = [0.05, 0, 0.3] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.3, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q4", link = [0.25, 0.02, 0] },
         { type = "revolute", axis = "+y", variable = "q5", link = [0.1, 0, 0] },
         { type = "revolute", axis = "+x", variable = "q6", link = [0.1, 0, 0] }]
)toml",
      "", turned_frames},
     // A wrist of three turns, the last of them given; the first axis leans, so that the arm moves on a cone.
     {R"toml(given = "q6"
joint = [{ type = "revolute", axis = [0, "3/5", "4/5"], variable = "q1", link = [0.05, 0.04, 0.3] },
         { type = "revolute", axis = "+y", variable = "q2", link = [0.3, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.25, 0.1, 0] },
         { type = "revolute", axis = "-y", variable = "q4", link = [0.05, 0.02, 0] },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.05, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q6", link = [0.1, 0, 0.05] }]
)toml"}}};

}  // namespace qvgen::test
