// SPDX-License-Identifier: MIT
#include "emit/math/singularities.h"

#include <algorithm>

#include "canonical/arm.h"
#include "dag/import.h"
#include "emit/math/legend.h"
#include "emit/math/lines.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

using derive::SingularFactor;
using GiNaC::ex;

constexpr int certificate_points = 3;

symbolic::Program program_of(const std::string& name, const ex& value) {
  symbolic::Program program;
  program.output(name, value);
  return program;
}

std::string text_of(const ex& value, Notation notation) {
  const dag::Function function = dag::import(program_of("", value));
  return formula(function.graph, function.outputs.front().value, notation);
}

/// The graph's sign rule decides between a factor and its negative.
bool is_negative(const ex& value) {
  return dag::import(program_of("", value)).outputs.front().value.negative;
}

void put_in_order(derive::Singularities& all) {
  for (SingularFactor& factor : all.factors) {
    if (!is_negative(factor.value)) continue;
    factor.value = -factor.value;
    if (factor.multiplicity % 2 != 0) all.constant = -all.constant;
  }
  std::sort(all.factors.begin(), all.factors.end(), [](const SingularFactor& a, const SingularFactor& b) {
    return std::pair(a.cause.kind, text_of(a.value, Notation::text)) <
           std::pair(b.cause.kind, text_of(b.value, Notation::text));
  });
}

/// "shoulder", "elbow", ...; several of one kind are numbered.
std::vector<std::string> names_of(const std::vector<SingularFactor>& factors) {
  std::vector<std::string> kinds, names;
  for (const SingularFactor& factor : factors) kinds.push_back(derive::to_string(factor.cause.kind));
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto here = kinds.begin() + static_cast<std::ptrdiff_t>(i);
    const auto before = std::count(kinds.begin(), here, *here);
    const bool alone = std::count(kinds.begin(), kinds.end(), *here) == 1;
    names.push_back(alone ? *here : *here + " " + std::to_string(before + 1));
  }
  return names;
}

void certify_product(const model::Robot& robot, const derive::Singularities& all) {
  symbolic::Program product;
  ex value = all.constant;
  for (const SingularFactor& factor : all.factors) value *= GiNaC::pow(factor.value, factor.multiplicity);
  product.output("determinant", value);
  verify::certify(dag::import(product), derive::determinant_definition(robot, all.rows), certificate_points,
                  "factors of the determinant");
}

SingularityMeasures not_factored(const model::Robot& robot) {
  SingularityMeasures result;
  result.quantity.name = "singularity_measures";
  if (robot.joints.size() != 6) return result;
  result.rows = {0, 1, 2, 3, 4, 5};
  result.names = {"determinant"};
  result.multiplicities = {1};
  result.constant = "1";
  result.quantity.forms.push_back({"minors", derive::determinant_by_frames(robot)});
  result.quantity.definition = derive::determinant_definition(robot, result.rows);
  return result;
}

std::string rows_text(const std::vector<int>& rows) {
  const char* names[] = {"vx", "vy", "vz", "wx", "wy", "wz"};
  std::string text;
  for (const int row : rows) text += (text.empty() ? "" : ", ") + std::string(names[row]);
  return text;
}

}  // namespace

SingularityMeasures singularity_measures(const model::Robot& robot) {
  derive::Singularities all = derive::singularities(robot);
  if (all.rows.empty()) return not_factored(robot);
  put_in_order(all);
  certify_product(robot, all);
  SingularityMeasures result;
  result.rows = all.rows;
  result.decoupled = all.decoupled;
  result.constant = text_of(all.constant, Notation::text.with(Numbers::exact));
  result.quantity.name = "singularity_measures";
  result.names = names_of(all.factors);
  symbolic::Program program;
  for (const SingularFactor& factor : all.factors) {
    program.output("m" + std::to_string(result.multiplicities.size() + 1), factor.value);
    result.multiplicities.push_back(factor.multiplicity);
  }
  result.quantity.forms.push_back({"factors", program});
  result.quantity.definition = program;
  return result;
}

SingularityFormulas singularity_formulas(const model::Robot& described, Notation notation) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const model::Robot& robot = arm.robot;
  derive::Singularities all = derive::singularities(robot);
  if (all.rows.empty()) {
    if (robot.joints.size() > 6)
      return {"more than six joints: the Jacobian has no determinant; singular where det(J J^T) = 0"};
    return {"the determinant of the Jacobian is not factored (" + all.not_factored + ")" +
            (robot.joints.size() == 6 ? "; singularity_measures computes it" : "")};
  }
  put_in_order(all);
  certify_product(robot, all);
  SingularityFormulas result;
  result.legend = legend(described, arm);
  result.determinant = "determinant of the rows " + rows_text(all.rows) + " of the Jacobian" +
                       (all.decoupled ? " (spherical wrist: arm and wrist decoupled)" : "");
  const std::string constant = text_of(all.constant, notation);
  result.product = constant == "1" ? "" : constant == "-1" ? "-" : constant;
  const std::vector<std::string> names = names_of(all.factors);
  for (std::size_t i = 0; i < all.factors.size(); ++i) {
    const SingularFactor& factor = all.factors[i];
    const std::string name = formula("f" + std::to_string(i + 1), notation);
    result.product += (result.product.empty() || result.product == "-" ? "" : " ") + name +
                      (factor.multiplicity > 1 ? "^" + std::to_string(factor.multiplicity) : "");
    result.factors.push_back({names[i], name, text_of(factor.value, notation), factor.cause.meaning});
  }
  return result;
}

namespace {

void add_equation(std::vector<std::string>& lines, const std::string& left, const std::string& right) {
  lines.emplace_back("\\begin{align*}");
  for (const std::string& line : equation_lines(left, right, Notation::latex)) lines.push_back(line);
  lines.emplace_back("\\end{align*}");
}

std::vector<std::string> typeset(const SingularityFormulas& all) {
  std::vector<std::string> lines;
  for (const std::string& line : all.legend) lines.push_back(latex_words(line) + ".");
  lines.push_back("$D$: the " + latex_words(all.determinant) + ".");
  add_equation(lines, "D", all.product);
  for (const auto& factor : all.factors) {
    lines.push_back("\\paragraph{" + factor.kind + "} " + latex_words(factor.meaning) + ":");
    add_equation(lines, factor.name, factor.value + " = 0");
  }
  return lines;
}

}  // namespace

std::vector<std::string> singularity_lines(const model::Robot& described, Notation notation) {
  const SingularityFormulas all = singularity_formulas(described, notation);
  if (all.factors.empty()) return {notation.typeset ? latex_words(all.none) : all.none};
  if (notation.typeset) return typeset(all);
  std::vector<std::string> lines = all.legend;
  lines.push_back(all.determinant + " = " + all.product);
  for (const auto& factor : all.factors)
    lines.push_back(factor.kind + ": " + factor.name + " = " + factor.value + " = 0 (" + factor.meaning +
                    ")");
  return lines;
}

}  // namespace qvgen::emit
