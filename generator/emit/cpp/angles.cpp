// SPDX-License-Identifier: MIT
#include "emit/cpp/angles.h"

#include "emit/cpp/printer.h"
#include "emit/leaves.h"

namespace qvgen::emit {

using dag::Angle;
using dag::Op;

std::vector<std::string> sine_cosine_declarations(const model::Robot& robot, const dag::Function& function,
                                                  const std::vector<Angle>& angles) {
  std::vector<std::string> lines;
  for (const auto& [place, op] : sines_and_cosines_of(function, angles)) {
    const std::string letter = op == Op::sine ? "s" : "c";
    const std::string name = angle_name(robot, angles[place], place);
    // A name by the place alone says nothing of its angle.
    const std::string note = name.front() == '_' ? "  // of " + to_string(angles[place]) : "";
    lines.push_back("const Scalar& " + letter + name + " = angles." + (op == Op::sine ? "sine" : "cosine") +
                    "[" + std::to_string(place) + "];" + note);
  }
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
