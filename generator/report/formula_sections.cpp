// SPDX-License-Identifier: MIT
#include "report/formula_sections.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "emit/math/closed_form.h"
#include "emit/math/dynamics_closed_form.h"
#include "emit/math/legend.h"
#include "emit/math/mathml.h"
#include "emit/math/notation.h"
#include "emit/math/singularities.h"
#include "emit/render.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "optimise/dynamics.h"
#include "passes/differentiate.h"
#include "passes/pass.h"
#include "verify/certificate.h"

namespace qvgen::report {
namespace {

using emit::Notation;
using nlohmann::json;

/// Entries longer than this say nothing to a reader.
constexpr std::size_t readable = 400;
/// So do closed forms, all lines together; those of the seven joints of an iiwa have a third of it.
constexpr std::size_t readable_lines = 30000;

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::size_t length_of(const std::vector<std::string>& lines) {
  std::size_t length = 0;
  for (const std::string& line : lines) length += line.size();
  return length;
}

/// The Jacobian's entries, zeros left out, long ones counted.
struct Entries {
  std::vector<std::string> lines;
  int zeros = 0;
  int long_ones = 0;
};

/// The linear rows of the Jacobian's definition.
symbolic::Program linear_definition(const model::Robot& robot) {
  const symbolic::Program whole = derive::jacobian_definition(robot);
  symbolic::Program linear;
  for (const auto& step : whole.steps()) linear.append(step);
  for (const auto& output : whole.outputs())
    if (output.name.front() == 'v') linear.output(output.name, output.value);
  return linear;
}

/// The velocity of the tool point by differentiating the closed form of its position, certified; nothing
/// where there is no closed form.
std::optional<dag::Function> linear_rows(const model::Robot& robot) {
  const auto program = derive::closed_form(robot);
  if (!program || model::has_followers(robot)) return std::nullopt;
  dag::Function function = dag::import(*program);
  std::erase_if(function.outputs, [](const dag::Output& output) { return output.name.front() != 'p'; });
  std::vector<passes::Direction> directions;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    directions.push_back({robot.joints[i].variable, "v", i + 1});
  passes::append_derivatives(function, directions);
  std::erase_if(function.outputs, [](const dag::Output& output) { return output.name.front() == 'p'; });
  const symbolic::Program definition = linear_definition(robot);
  const std::vector<dag::Output> columns = std::move(function.outputs);
  function.outputs.clear();
  for (const auto& entry : definition.outputs())
    function.outputs.push_back(*std::find_if(columns.begin(), columns.end(), [&](const dag::Output& output) {
      return output.name == entry.name;
    }));
  verify::certify(function, definition, 3, "Jacobian");
  return function;
}

dag::Function by_cross_products(const model::Robot& robot) {
  const auto forms = derive::jacobian_methods(robot);
  const auto crosses = std::find_if(forms.begin(), forms.end(), [](const derive::Form& form) {
    return form.name == "cross products of axes";
  });
  return passes::simplify(dag::import(crosses->program));
}

Entries jacobian_entries(const model::Robot& robot) {
  const canonical::Arm arm = canonical::for_kinematics(robot);
  const auto linear = linear_rows(arm.robot);
  Entries entries;
  const auto add = [&](const dag::Function& canonical, bool angular_alone) {
    const dag::Function function = optimise::in_terms_of_description(canonical, arm);
    for (const dag::Output& output : function.outputs) {
      const bool is_linear = output.name.front() == 'v';
      if (is_linear && angular_alone) continue;
      const std::string value = emit::formula(function.graph, output.value, Notation::latex);
      const int row = std::stoi(output.name.substr(1, 1)) + (is_linear ? 0 : 3);
      if (value == "0")
        ++entries.zeros;
      else if (value.size() > readable)
        ++entries.long_ones;
      else
        entries.lines.push_back(fmt::format("J_{{{},{}}} = {}", row, output.name.substr(3), value));
    }
  };
  if (linear) add(*linear, false);
  add(by_cross_products(arm.robot), linear.has_value());
  std::sort(entries.lines.begin(), entries.lines.end());  // J_{1,1}, J_{1,2}, ...
  return entries;
}

std::string jacobian_html(const model::Robot& robot) {
  const Entries entries = jacobian_entries(robot);
  std::string text =
      "Rows 1 to 3 are the tool point’s velocity, rows 4 to 6 the tool’s angular velocity, in the base "
      "frame, per unit of the joints’ rates.";
  if (entries.zeros > 0) text += fmt::format(" {} entries are zero.", entries.zeros);
  if (entries.long_ones > 0)
    text += fmt::format(" {} are too long to be read; the code computes them with common parts shared.",
                        entries.long_ones);
  return paragraph(text) + (entries.lines.empty() ? "" : formulas_html(entries.lines));
}

std::string singularities_html(const model::Robot& robot) {
  const emit::SingularityFormulas all = emit::singularity_formulas(robot, Notation::latex);
  std::string text = "<h3 id=\"singularities\">Singularities</h3>\n";
  if (all.factors.empty()) return text + paragraph(escaped(all.none) + ".");
  for (const std::string& line : all.legend) text += paragraph(escaped(line) + ".");
  text += paragraph("The " + escaped(all.determinant) + " is " + emit::inline_mathml(all.product) +
                    ": the arm is singular exactly where a factor vanishes.");
  for (const auto& factor : all.factors) {
    text += "<h4>" + escaped(factor.kind) + "</h4>\n" + paragraph(escaped(factor.meaning) + ".");
    text += formulas_html({factor.name + " = " + factor.value + " = 0"});
  }
  return text;
}

}  // namespace

Section forward_section(const model::Robot& robot) {
  const auto lines = emit::pose_formulas(robot, Notation::latex);
  std::string html = paragraph(
      "The tool’s pose in the world: a unit quaternion w, x, y, z and a position, by the product of the "
      "joints’ "
      "quaternion/vector pairs. A bar over an angle is half of it.");
  if (lines.empty())
    html += paragraph("A constant rotation by a symbolic angle: no closed form in half-angle sums.");
  else if (length_of(lines) > readable_lines)
    html +=
        paragraph("Written out it is too long to be read; the code computes it with common parts shared.");
  else
    html += formulas_html(lines);
  return {"forward", "Forward kinematics", html};
}

Section jacobian_section(const model::Robot& robot) {
  return {"jacobian", "Jacobian and singularities",
          jacobian_html(robot) + (model::has_followers(robot) ? "" : singularities_html(robot))};
}

Section dynamics_section(const model::Robot& robot) {
  const std::string id = "dynamics";
  const std::string title = "Dynamics";
  if (!optimise::has_inertia(robot)) return {id, title, paragraph("The description has no inertia.")};
  if (model::has_followers(robot))
    return {id, title,
            paragraph("Not written out where a joint follows another. The code computes the forces of all "
                      "joints by the Newton–Euler recursion and gathers them by the ratios.")};
  if (robot.joints.size() > 3)
    return {
        id, title,
        paragraph("Written out, the joint forces of more than three joints are too long to be read. The code "
                  "computes them by the Newton–Euler recursion; its operations are counted below.")};
  std::vector<std::string> lines;
  std::size_t joint = robot.joints.size();
  for (const emit::ForceTerm& term : emit::dynamics_closed_form(robot)) {
    const std::string coefficient =
        emit::formula(term.coefficient.graph, term.coefficient.outputs.front().value, Notation::latex);
    const std::string value = "(" + coefficient + ") " + emit::motion_formula(term.motion, Notation::latex);
    if (term.joint != joint)
      lines.push_back("\\tau_{" + std::to_string(term.joint + 1) + "} = " + value);
    else
      lines.back() += " + " + value;
    joint = term.joint;
  }
  return {id, title,
          paragraph("Joint forces (Nm, N), by accelerations, products of rates, and gravity.") +
              formulas_html(lines)};
}

}  // namespace qvgen::report
