// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <sstream>
#include <string>

namespace qvgen::test {

/// A joint's type and axis, and what it carries along; a request in front of all of them.
struct TurnedArm {
  const char* request;
  const char* joints;  ///< "revolute +z 0.3 0 0.1; ..."
};

/// Arms that are asked for less than a pose, or for few poses, between a base and a tool turned by decimals:
/// what such a task leaves open is open in the described frames.
inline constexpr std::array<TurnedArm, 8> turned_arms{{
    {"", "revolute +z 0.05 0 0.3; revolute +y 0.3 0 0; revolute +y 0.25 0 0"},
    {"", "revolute +z 0 0 0.3; revolute -y 0 0 0; prismatic +z 0 0 0"},
    {"", "revolute +z 0 0 0.1; revolute -y 0.05 0 0.02"},
    {"", "revolute +z 0.3 0 0; revolute +z 0.25 0 0; prismatic -z 0 0 0; revolute -z 0 0 0"},
    {"",
     "revolute +z 0 0 0.3; revolute +y 0.3 0 0; revolute +y 0.25 0 0; revolute +y 0.05 0 0; revolute +z 0 0 "
     "0.1"},
    {"task = \"position\"\ngiven = \"q4\"\n",
     "revolute +z 0.05 0 0.3; revolute +y 0.3 0 0; revolute +y 0.25 0 0; revolute +x 0.1 0 0"},
    {"", "revolute +z 0.3 0 0; revolute +z 0.25 0 0"},
    {"", "prismatic +x 0 0 0; prismatic +y 0 0 0; prismatic -z 0 0 -0.2"},
}};

inline std::string turned_arm(const std::string& name, std::size_t which) {
  const TurnedArm& arm = turned_arms.at(which);
  std::string text = "name = \"" + name + "\"\ntitle = \"arm between turned frames\"\n" + arm.request +
                     "[base]\ntranslation = [0.1, 0.2, 0.3]\nrpy = [\"33 deg\", \"-12 deg\", \"41 deg\"]\n" +
                     "[tool]\ntranslation = [0.01, 0.02, 0.1]\nrpy = [0.2, \"20 deg\", \"30 deg\"]\n";
  std::istringstream joints(arm.joints);
  std::string type, axis, x, y, z;
  for (int i = 1; joints >> type >> axis >> x >> y >> z; ++i) {
    if (z.back() == ';') z.pop_back();
    text += "[[joint]]\ntype = \"" + type + "\"\naxis = \"" + axis + "\"\nvariable = \"q" +
            std::to_string(i) + "\"\nlink = [" + x + ", " + y + ", " + z + "]\n";
  }
  return text;
}

}  // namespace qvgen::test
