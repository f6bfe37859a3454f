// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace qvgen::test {

/// An arm as it is built, without name and title, and the line that asks for a joint to be given, empty to
/// leave it to the generator.
struct SevenJointArm {
  const char* given;
  const char* table;

  [[nodiscard]] std::string text() const { return std::string(given) + table; }
};

/// Spherical shoulder and wrist around a plain elbow.
inline constexpr const char* plain_elbow = R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", d = 0.34, alpha = "-90 deg" },
      { theta = "q2", variable = "q2", alpha = "90 deg" },
      { theta = "q3", variable = "q3", d = 0.4, alpha = "90 deg" },
      { theta = "q4", variable = "q4", alpha = "-90 deg" },
      { theta = "q5", variable = "q5", d = 0.4, alpha = "-90 deg" },
      { theta = "q6", variable = "q6", alpha = "90 deg" },
      { theta = "q7", variable = "q7", d = 0.126 }]
)toml";

inline constexpr std::array<SevenJointArm, 6> seven_arms{
    {// Spherical shoulder, offset elbow and wrist (link lengths of the Franka arm).
     {"", R"toml(convention = "modified"
dh = [{ theta = "q1", variable = "q1", d = 0.333 },
      { theta = "q2", variable = "q2", alpha = "-90 deg" },
      { theta = "q3", variable = "q3", alpha = "90 deg", d = 0.316 },
      { theta = "q4", variable = "q4", alpha = "90 deg", a = 0.0825 },
      { theta = "q5", variable = "q5", alpha = "-90 deg", a = -0.0825, d = 0.384 },
      { theta = "q6", variable = "q6", alpha = "90 deg" },
      { theta = "q7", variable = "q7", alpha = "90 deg", a = 0.088 }]
tool = { translation = [0, 0, 0.107] }
)toml"},
     // Spherical shoulder and wrist, offset elbow (link lengths of the WAM arm).
     {"", R"toml(convention = "standard"
dh = [{ theta = "q1", variable = "q1", alpha = "-90 deg" },
      { theta = "q2", variable = "q2", alpha = "90 deg" },
      { theta = "q3", variable = "q3", alpha = "-90 deg", a = 0.045, d = 0.55 },
      { theta = "q4", variable = "q4", alpha = "90 deg", a = -0.045 },
      { theta = "q5", variable = "q5", alpha = "-90 deg", d = 0.3 },
      { theta = "q6", variable = "q6", alpha = "90 deg" },
      { theta = "q7", variable = "q7", d = 0.06 }]
)toml"},
     // An arm with a wrist on a rail.
     {"", R"toml(convention = "standard"
dh = [{ d = "q1", variable = "q1", alpha = "-90 deg" },
      { theta = "q2", variable = "q2", d = 0.4, a = 0.15, alpha = "90 deg" },
      { theta = "q3", variable = "q3", a = 0.6 },
      { theta = "q4", variable = "q4", a = 0.1, alpha = "90 deg" },
      { theta = "q5", variable = "q5", d = 0.7, alpha = "-90 deg" },
      { theta = "q6", variable = "q6", alpha = "90 deg" },
      { theta = "q7", variable = "q7", d = 0.1 }]
)toml"},
     // Three parallel axes on a rail (link lengths of the UR5).
     {"", R"toml(convention = "standard"
dh = [{ d = "q1", variable = "q1", alpha = "-90 deg" },
      { theta = "q2", variable = "q2", d = 0.089159, alpha = "90 deg" },
      { theta = "q3", variable = "q3", a = -0.425 },
      { theta = "q4", variable = "q4", a = -0.39225 },
      { theta = "q5", variable = "q5", d = 0.10915, alpha = "90 deg" },
      { theta = "q6", variable = "q6", d = 0.09465, alpha = "-90 deg" },
      { theta = "q7", variable = "q7", d = 0.0823 }]
)toml"},
     {"given = \"q5\"\n", plain_elbow},
     // The third joint turns about the arm when it is stretched.
     {"given = \"q1\"\n", plain_elbow}}};

}  // namespace qvgen::test
