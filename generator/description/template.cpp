// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "description/reader.h"
#include "description/write.h"

namespace qvgen::description {
namespace {

std::string joint(std::size_t number, bool revolute, const std::string& axis, const std::string& more) {
  return fmt::format(
      "\n[[joint]]                   # {0}\ntype = \"{1}\"\naxis = \"{2}\"               # or three numbers "
      "of "
      "length 1, [\"3/5\", 0, 0.8]\nvariable = \"{3}{0}\"\n{4}",
      number, revolute ? "revolute" : "prismatic", axis, revolute ? "theta" : "d", more);
}

}  // namespace

std::optional<std::string> write_template(const std::string& name, const std::string& letters,
                                          bool euler_wrist) {
  if (letters.empty() || letters.size() + (euler_wrist ? 3 : 0) > max_joints) return std::nullopt;
  std::string text = fmt::format(
      "# Edit this, then: qvgen check, qvgen show, qvgen generate. Lengths in metres, angles in radians "
      "unless they say deg.\n"
      "# Numbers are exact and become part of the code; a name such as \"l1\" becomes a field of Geometry, "
      "its value here is\n"
      "# the default. generator/robots/README.md has every key: tables of Denavit and Hartenberg, screws, "
      "inertia, friction.\n"
      "name = \"{}\"             # namespace and file name of the generated code\ntitle = "
      "\"{}\"\n\n[defaults]\n",
      name, letters + (euler_wrist ? " with Euler wrist" : ""));
  for (std::size_t i = 1; i <= letters.size(); ++i)
    text += fmt::format("l{} = {}\n", i, i == 1 ? "0.5" : "0.4");
  text += "\n[tool]                      # last link -> tool\ntranslation = [0, 0, 0.1]\n";
  std::size_t number = 0;
  for (const char letter : letters) {
    if (letter != 'R' && letter != 'P') return std::nullopt;
    const bool revolute = letter == 'R';
    ++number;
    // The first joint stands upright; those behind it turn about, or slide along, what lets them reach
    // around.
    const std::string axis = number == 1 ? "+z" : revolute ? "+y" : "+x";
    const std::string length = fmt::format("\"l{}\"", number);
    text += joint(number, revolute, axis,
                  fmt::format("link = [{}]        # carried along by the joint\nlimits = [{}]\n",
                              number == 1 ? "0, 0, " + length : length + ", 0, 0",
                              revolute ? "\"-170 deg\", \"170 deg\"" : "0, 0.5"));
  }
  for (const std::string axis : {"+z", "+y", "+z"}) {
    if (!euler_wrist) break;
    text += joint(++number, true, axis, "limits = [\"-180 deg\", \"180 deg\"]\n");
  }
  return text;
}

}  // namespace qvgen::description
