// SPDX-License-Identifier: MIT
#include "emit/cpp/angles.h"

#include "emit/cpp/printer.h"
#include "emit/leaves.h"

namespace qvgen::emit {

using dag::Angle;
using dag::Op;

namespace {

/// A reference to the sine or cosine of an angle: "&s1 = angles.sine[0]".
std::string reference(const std::string& name, std::size_t place, Op op) {
  const bool is_sine = op == Op::sine;
  return "&" + ((is_sine ? "s" : "c") + name) + " = angles." + (is_sine ? "sine[" : "cosine[") +
         std::to_string(place) + "]";
}

}  // namespace

std::vector<std::string> sine_cosine_declarations(const model::Robot& robot, const dag::Function& function,
                                                  const std::vector<Angle>& angles) {
  constexpr std::size_t longest_statement = 4;  // references
  std::vector<std::string> lines, notes;
  std::size_t count = 0;
  for (const auto& [place, op] : sines_and_cosines_of(function, angles)) {
    const std::string name = angle_name(robot, angles[place], place);
    if (count++ % longest_statement == 0)
      lines.push_back("const Scalar " + reference(name, place, op));
    else
      lines.back() += ", " + reference(name, place, op);
    // A name by the place alone says nothing of its angle.
    if (name.front() == '_')
      notes.push_back("// " + ((op == Op::sine ? "s" : "c") + name) + ": of " + to_string(angles[place]));
  }
  for (std::string& line : lines) line += ";";
  lines.insert(lines.end(), notes.begin(), notes.end());
  return lines;
}

nlohmann::json angle_values(const std::vector<Angle>& angles, const ast::Leaves& leaves) {
  nlohmann::json values = nlohmann::json::array();
  for (std::size_t i = 0; i < angles.size(); ++i)
    values.push_back({{"text", to_string(angles[i])},
                      {"code", angle_code(angles[i], leaves, plain_cpp())},
                      {"index", i},
                      {"last", i + 1 == angles.size()}});
  return values;
}

std::string sines_cosines_code(const std::vector<Angle>& angles, const ast::Leaves& leaves,
                               const std::string& empty) {
  if (angles.empty()) return empty + "<Scalar>{}";
  std::string arguments;
  for (const Angle& angle : angles)
    arguments += (arguments.empty() ? "" : ", ") + angle_code(angle, leaves, plain_cpp());
  return "sines_and_cosines<Scalar>(" + arguments + ")";
}

}  // namespace qvgen::emit
