// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace qvgen::test {

/// Arms with a telescoping tool behind a wrist, which certain orientations leave free; by the two joints
/// before the wrist.
inline constexpr std::array<const char*, 4> before_the_wrist{
    // The tool level: a slide across the first axis follows, if the tool's point is far enough from that
    // axis.
    R"([[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q1"
origin = [0, 0, 0]
link = ["1/2", 0, "3/4"]
[[joint]]
type = "prismatic"
axis = [0, 1, 0]
variable = "q2"
origin = [0, 0, 0]
)",
    // The tool level: a link that turns follows, if the tool's point is neither too far from the first axis
    // nor too near.
    R"([[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q1"
origin = [0, 0, 0]
link = ["1/2", 0, "3/4"]
[[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q2"
origin = [0, 0, 0]
link = ["2/3", 0, 0]
)",
    // Three slides in a plane.
    R"([[joint]]
type = "prismatic"
axis = [0, 0, 1]
variable = "q1"
origin = [0, 0, 0]
[[joint]]
type = "prismatic"
axis = [1, 0, 0]
variable = "q2"
origin = [0, 0, 0]
)",
    // The tool in the plane of the first slide and the link.
    R"([[joint]]
type = "prismatic"
axis = [0, 0, 1]
variable = "q1"
origin = [0, 0, 0]
[[joint]]
type = "revolute"
axis = [1, 0, 0]
variable = "q2"
origin = [0, 0, 0]
link = ["1/4", "1/2", 0]
)"};

inline std::string sliding_arm(const std::string& name, std::size_t which) {
  std::string text =
      "name = \"" + name + "\"\ntitle = \"arm with a telescoping tool\"\n" + before_the_wrist.at(which);
  const std::array<const char*, 3> axes{"[0, 1, 0]", "[1, 0, 0]", "[0, 1, 0]"};
  for (std::size_t i = 0; i < 3; ++i)
    text += "[[joint]]\ntype = \"revolute\"\naxis = " + std::string(axes[i]) + "\nvariable = \"q" +
            std::to_string(i + 3) + "\"\norigin = [0, 0, 0]\nlink = [0, 0, 0]\n";
  return text +
         "[[joint]]\ntype = \"prismatic\"\naxis = [1, 0, 0]\nvariable = \"q6\"\norigin = [\"1/5\", 0, "
         "\"1/3\"]\n";
}

}  // namespace qvgen::test
