// SPDX-License-Identifier: MIT
#include "emit/math/closed_form.h"

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/kinematics/forward_kinematics.h"
#include "optimise/described.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

constexpr std::size_t comment_width = 112;

/// The last place at which a line may end: before a + or - that stands in no parentheses.
std::size_t last_break(const std::string& text) {
  std::size_t best = std::string::npos;
  int depth = 0;
  for (std::size_t i = 0; i < text.size() && i <= comment_width; ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    const bool term = depth == 0 && i > 8 && text[i] == ' ' &&
                      (text.compare(i, 3, " + ") == 0 || text.compare(i, 3, " - ") == 0);
    if (term) best = i;
  }
  return best;
}

/// Broken before terms; continuation lines are indented.
std::vector<std::string> wrapped(const std::string& text) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > comment_width) {
    const std::size_t end = last_break(rest);
    if (end == std::string::npos) break;
    lines.push_back(rest.substr(0, end));
    rest = "    " + rest.substr(end + 1);
  }
  lines.push_back(rest);
  return lines;
}

}  // namespace

std::vector<std::string> closed_form_lines(const model::Robot& described, Notation notation) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const model::Robot& robot = arm.robot;
  const auto program = derive::closed_form(robot);
  if (!program) return {};
  dag::Function function = dag::import(*program);
  verify::certify(function, derive::forward_kinematics(robot).definition, 2, robot.name + ": closed form");
  function = optimise::in_terms_of_description(function, arm);
  std::vector<std::string> lines;
  for (const dag::Output& output : function.outputs) {
    const std::string name =
        output.name.size() == 2 && notation.typeset ? "p_" + output.name.substr(1) : output.name;
    const std::string line = name + " = " + formula(function.graph, output.value, notation);
    if (notation.typeset)
      lines.push_back(line);
    else
      for (const std::string& part : wrapped(line)) lines.push_back(part);
  }
  return lines;
}

}  // namespace qvgen::emit
