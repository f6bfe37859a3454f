// SPDX-License-Identifier: MIT
#include "emit/math/closed_form.h"

#include <optional>

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/kinematics/forward_kinematics.h"
#include "emit/math/collect.h"
#include "emit/math/lines.h"
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
std::vector<std::string> in_lines(const std::string& text) {
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

/// Nothing where a constant rotation by a symbolic angle stands in the way. `collect`: what terms have in
/// common is taken out.
std::optional<dag::Function> pose(const model::Robot& described, bool collect) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto program = derive::closed_form(arm.robot);
  if (!program) return std::nullopt;
  dag::Function function = dag::import(*program);
  if (collect) function = collected(std::move(function));
  verify::certify(function, derive::forward_kinematics(arm.robot).definition, 2,
                  arm.robot.name + ": closed form");
  return optimise::in_terms_of_description(function, arm);
}

/// "w = ...", "p_x = ..."
std::vector<std::string> equations(const std::optional<dag::Function>& function, Notation notation) {
  std::vector<std::string> all;
  if (!function) return all;
  for (const dag::Output& output : function->outputs) {
    const bool has_index = notation.typeset && output.name.size() == 2;
    all.push_back((has_index ? "p_" + output.name.substr(1) : output.name) + " = " +
                  formula(function->graph, output.value, notation));
  }
  return all;
}

}  // namespace

std::vector<std::string> closed_form_lines(const model::Robot& described, Notation notation) {
  std::vector<std::string> lines;
  for (const std::string& equation : equations(pose(described, false), notation))
    for (const std::string& part : in_lines(equation)) lines.push_back(part);
  return lines;
}

std::vector<std::string> pose_formulas(const model::Robot& described, Notation notation) {
  return equations(pose(described, true), notation);
}

std::vector<std::string> pose_lines(const model::Robot& described, Notation notation) {
  const std::vector<std::string> formulas = pose_formulas(described, notation);
  if (formulas.empty()) return {};
  std::vector<std::string> lines;
  if (notation.typeset) lines = {"$\\bar\\theta$: half of an angle.", "\\begin{align*}"};
  for (const std::string& formula : formulas)
    for (const std::string& line : formula_lines(formula, notation)) lines.push_back(line);
  if (notation.typeset) lines.emplace_back("\\end{align*}");
  return lines;
}

}  // namespace qvgen::emit
