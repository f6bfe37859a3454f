// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "built_arms.h"

namespace qvgen::test {

/// Arms of five joints without a closed form that are asked for a position and an inclination, as they are
/// built, without names and titles.
inline constexpr std::array<BuiltArm, 6> heading_arms{
    {// Base, shoulder, elbow, and a wrist of two axes that do not move in one plane with them.
     {R"toml(joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0, 0, 0.3] },
         { type = "revolute", axis = "+y", variable = "q2", link = [0.3, 0, 0] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.25, 0, 0] },
         { type = "revolute", axis = "+z", variable = "q4", link = [0.05, 0, 0.03] },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.1, 0, 0] }]
)toml"},
     // A rail before the first turn, a length by name, between frames turned by decimals.
     {R"toml(joint = [{ type = "prismatic", axis = "+x", variable = "q1" },
         { type = "revolute", axis = "+z", variable = "q2", link = [0.1, 0, "h"] },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.25, 0, 0] },
         { type = "revolute", axis = "+z", variable = "q4", link = [0.05, 0.1, 0.03] },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.1, 0, 0.04] }]
[defaults]
h = 0.3
)toml",
      "", turned_frames},
     // A boom that extends behind a leaning column, then a wrist.
     {R"toml(joint = [{ type = "revolute", axis = [0, "3/5", "4/5"], variable = "q1", link = [0.1, 0.05, 0.4] },
         { type = "revolute", axis = "+y", variable = "q2", link = [0.3, 0.07, 0.1] },
         { type = "prismatic", axis = "+x", variable = "q3" },
         { type = "revolute", axis = "+x", variable = "q4", link = [0.08, 0.05, 0.1] },
         { type = "revolute", axis = "+y", variable = "q5", link = [0.08, 0.05, 0.1] }]
)toml"},
     // Two slides.
     {R"toml(joint = [{ type = "revolute", axis = "+z", variable = "q1", link = [0.1, 0.05, 0.4] },
         { type = "prismatic", axis = "+x", variable = "q2" },
         { type = "revolute", axis = "+y", variable = "q3", link = [0.3, 0.07, 0.1] },
         { type = "prismatic", axis = "+z", variable = "q4" },
         { type = "revolute", axis = "+x", variable = "q5", link = [0.08, 0.05, 0.1] }]
)toml"},
     // Six joints with a spherical wrist, the last one given.
     {"given = \"q6\"\n", wrist_arm},
     // The first one given: the heading is about its axis.
     {"given = \"q1\"\n", wrist_arm}}};

}  // namespace qvgen::test
