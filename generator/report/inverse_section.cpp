// SPDX-License-Identifier: MIT
#include "derive/inverse/lower.h"
#include "emit/math/ability.h"
#include "emit/math/describe.h"
#include "emit/math/legend.h"
#include "emit/math/mathml.h"
#include "emit/math/subproblems.h"
#include "emit/render.h"
#include "pipeline/products/inverse_derivation.h"
#include "report/branch_signs.h"
#include "report/formula_sections.h"

namespace qvgen::report {
namespace {

using emit::Notation;
using nlohmann::json;

json line(const std::string& html) { return {{"html", html}}; }

/// Passages without a title go on with the one before.
json passages_json(const std::vector<emit::Passage>& passages) {
  json list = json::array();
  for (const emit::Passage& passage : passages) {
    const std::string formulas = passage.formulas.empty() ? "" : emit::aligned_mathml(passage.formulas);
    list.push_back({{"depth", std::to_string(std::min<std::size_t>(passage.depth, 4))},
                    {"has_title", !passage.title.empty()},
                    {"title", with_formulas(passage.title)},
                    {"has_equation", !passage.equation.empty()},
                    {"equation", with_formulas(passage.equation)},
                    {"has_formulas", !passage.formulas.empty()},
                    {"formulas", formulas},
                    {"has_degenerate", !passage.degenerate.empty()},
                    {"degenerate", with_formulas(passage.degenerate)}});
  }
  return list;
}

json derivation_json(const model::Robot& robot, const derive::inverse::Derivation& derivation) {
  const derive::inverse::Problem& problem = derivation.problem;
  json result{{"ability", escaped(emit::ability(robot, derivation))}, {"legend", json::array()}};
  for (const std::string& text : emit::legend(robot, {problem.moving, problem.phases}))
    result["legend"].push_back(line(escaped(text)));
  std::vector<emit::Passage> passages = emit::passages(derivation, Notation::latex);
  for (const emit::Passage& passage : emit::subproblem_passages(derivation, Notation::latex))
    passages.push_back(passage);
  result["passages"] = passages_json(passages);
  return result;
}

}  // namespace

Section inverse_section(const model::Robot& described) {
  const pipeline::InverseDerivation derivation = pipeline::derive_inverse(described);
  const model::Robot& robot = derivation.found() ? derivation.arm : described;
  json values{{"derivations", json::array()}, {"lines", json::array()}};
  for (const auto& elimination : derivation.eliminations) {
    values["lines"].push_back(line(escaped(emit::ability(robot, elimination))));
    for (const std::string& text : describe_elimination(elimination))
      values["lines"].push_back(line(escaped(text)));
  }
  if (const std::string by_angle = emit::arm_angle_ability(robot); !by_angle.empty())
    values["lines"].push_back(line(escaped(by_angle)));
  for (const auto& form : derivation.closed_forms)
    values["derivations"].push_back(derivation_json(robot, form));
  if (!derivation.found())
    for (const std::string& reason : derivation.reasons)
      values["lines"].push_back(line("None: " + escaped(reason) + "."));
  const std::string signs = derivation.closed_forms.empty()
                                ? ""
                                : branch_signs_html(branch_signs(derivation.closed_forms.front().plan));
  return {"inverse", "Inverse kinematics", emit::render("report/inverse.html", values) + signs};
}

}  // namespace qvgen::report
