// SPDX-License-Identifier: MIT
#pragma once

// Arms as they are built, in parts: families ask them for different things, and put them between different
// frames.
#include <string>

namespace qvgen::test {

/// A description without name and title.
struct BuiltArm {
  const char* keys;  ///< what is asked for, and all else if there is no more
  const char* links = "";
  const char* frames = "";
};

inline std::string text_of(const BuiltArm& arm) { return std::string(arm.keys) + arm.links + arm.frames; }

/// An arm with a spherical wrist.
inline constexpr const char* wrist_arm = R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.4, a = 0.025, alpha = "-90 deg" },
      { theta = "q2", variable = "q2", a = 0.56 },
      { theta = "q3", variable = "q3", a = 0.035, alpha = "-90 deg" },
      { theta = "q4", variable = "q4", d = 0.515, alpha = "90 deg" },
      { theta = "q5", variable = "q5", alpha = "-90 deg" },
      { theta = "q6", variable = "q6", d = 0.08 }]
)toml";

/// A desk arm of five servos with lateral offsets: pan, three pitches, roll.
inline constexpr const char* desk_arm =
    R"toml(joint = [{ type = "revolute", axis = "+z", variable = "pan", origin = [0.02, -0.02, 0.095], link = [-0.03, 0.018, 0.054] },
         { type = "revolute", axis = "+y", variable = "lift", link = [0.028, 0, 0.1126] },
         { type = "revolute", axis = "+y", variable = "elbow", link = [0.135, 0, 0.005] },
         { type = "revolute", axis = "+y", variable = "flex", link = [0.061, 0.018, 0] },
         { type = "revolute", axis = "+x", variable = "roll", link = [0.098, 0, 0] }]
)toml";

/// The youBot's arm: three parallel axes behind a first one across them, no lateral offset.
inline constexpr const char* youbot_arm = R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.147, a = 0.033, alpha = "90 deg" },
      { theta = "q2", variable = "q2", a = 0.155 },
      { theta = "q3", variable = "q3", a = 0.135 },
      { theta = "q4 + 90 deg", variable = "q4", alpha = "90 deg" },
      { theta = "q5", variable = "q5", d = 0.2175 }]
)toml";

/// Base and tool turned by decimals.
inline constexpr const char* turned_frames = R"toml([base]
translation = [0.1, 0.2, 0.3]
rpy = ["33 deg", "-12 deg", "41 deg"]
[tool]
translation = [0.01, 0.02, 0.1]
rpy = [0.2, "20 deg", "30 deg"]
)toml";

}  // namespace qvgen::test
