// SPDX-License-Identifier: MIT
#include "application/closed_form.h"

#include "application/certificate.h"
#include "dag/import.h"
#include "derive/forward_kinematics.h"

namespace qvgen::application {
namespace {

constexpr std::size_t comment_width = 112;

/// Breaks at spaces; continuation lines are indented.
std::vector<std::string> wrapped(const std::string& text) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > comment_width) {
    const std::size_t space = rest.rfind(' ', comment_width);
    if (space == std::string::npos || space < 8) break;
    lines.push_back(rest.substr(0, space));
    rest = "    " + rest.substr(space + 1);
  }
  lines.push_back(rest);
  return lines;
}

}  // namespace

std::vector<std::string> closed_form_lines(const model::Robot& robot, emit::Notation notation) {
  const auto program = derive::closed_form(robot);
  if (!program) return {};
  const dag::Function function = dag::import(*program);
  certify(function, derive::forward_kinematics(robot).definition, 2, robot.name + ": closed form");
  std::vector<std::string> lines;
  for (const dag::Output& output : function.outputs) {
    const std::string name = output.name.size() == 2 && notation == emit::Notation::latex ? "p_" + output.name.substr(1) : output.name;
    const std::string line = name + " = " + emit::formula(function.graph, output.value, notation);
    if (notation == emit::Notation::latex) lines.push_back(line);
    else for (const std::string& part : wrapped(line)) lines.push_back(part);
  }
  return lines;
}

}  // namespace qvgen::application
