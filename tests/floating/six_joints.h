// SPDX-License-Identifier: MIT
// A description whose base floats, and the same robot with six joints in place of the base.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

namespace qvgen::test::floating {

inline std::string text_of(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The description with three slides and three turns in place of the floating base.
inline std::string with_six_joints(std::string text) {
  const std::string begin = "[floating_base]\n", on_base = "parent = \"base\"";
  const std::size_t at = text.find(begin), end = text.find("\n\n", at);
  const std::string inertia = text.substr(at + begin.size(), end - at - begin.size()) + "\n";
  std::string six;
  for (const std::string axis : {"x", "y", "z"})
    six += "[[joint]]\ntype = \"prismatic\"\naxis = \"+" + axis + "\"\nvariable = \"base_" + axis + "\"\n";
  for (const std::string axis : {"z", "y", "x"})
    six += "[[joint]]\ntype = \"revolute\"\naxis = \"+" + axis + "\"\nvariable = \"base_r" + axis + "\"\n";
  text.replace(at, end - at, six + inertia);
  for (std::size_t place = text.find(on_base); place != std::string::npos; place = text.find(on_base))
    text.replace(place, on_base.size(), "parent = \"base_rx\"");
  return text;
}

}  // namespace qvgen::test::floating
