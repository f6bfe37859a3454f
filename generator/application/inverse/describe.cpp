// SPDX-License-Identifier: MIT
#include "application/inverse/describe.h"

#include "application/inverse/step_code.h"

namespace qvgen::application {

using derive::inverse::Kind;
using derive::inverse::Step;

namespace {

std::string kind_name(Kind kind) {
  switch (kind) {
    case Kind::circle: return "line or circle meets circle";
    case Kind::free_circle: return "line or circle meets circle";
    case Kind::factored: return "line meets circle, its discriminant in factors";
    case Kind::opposite: return "two opposite directions";
    case Kind::pair: return "turn of one known vector into another";
    case Kind::root: return "foot of the perpendicular and square root";
    case Kind::quadratic: return "quadratic";
    case Kind::linear: return "linear";
    case Kind::conic: return "conic meets circle (quartic)";
    case Kind::require: return "condition";
    case Kind::reach: return "a choice within reach";
    case Kind::half: return "half angle";
    case Kind::polish: return "Newton steps";
    case Kind::right_wrist: return "wrist with right angles, half-angle form";
    case Kind::oblique_wrist: return "wrist with oblique axes, half-angle form";
  }
  return {};
}

std::string branches(const Step& step) {
  return step.branches == 1 ? "one value" : std::to_string(step.branches) + (step.kind == Kind::conic ? " values at most" : " values");
}

/// Longer formulas say nothing to a reader.
constexpr std::size_t readable = 400;

std::vector<std::string> formulas(const dag::Function& function, emit::Notation notation) {
  std::vector<std::string> lines;
  for (const dag::Output& output : function.outputs) {
    const std::string text = emit::formula(function.graph, output.value, notation);
    if (text.size() <= readable) lines.push_back(emit::formula(output.name, notation) + " = " + text);
  }
  return lines;
}

std::string headline(const Step& step) {
  return step.unknown + ": " + kind_name(step.kind) + ", " + branches(step);
}

}  // namespace

std::vector<std::string> step_comment(const LoweredPlan& plan, std::size_t index) {
  const Step& step = plan.plan.steps[index];
  std::vector<std::string> lines = {headline(step) + ".", "From: " + step.equation + "."};
  if (!step.degenerate.empty()) lines.push_back("Degenerate: " + step.degenerate + ".");
  return lines;
}

std::vector<std::string> describe(const LoweredPlan& plan, emit::Notation notation) {
  std::vector<std::string> lines = {plan.plan.structure, "at most " + std::to_string(plan.plan.capacity) + " solutions", "target:"};
  for (const std::string& line : formulas(plan.target, notation)) lines.push_back("  " + line);
  std::string indent;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const Step& step = plan.plan.steps[i];
    lines.push_back(indent + headline(step));
    lines.push_back(indent + "  from: " + step.equation);
    for (const std::string& line : formulas(plan.steps[i].before, notation)) lines.push_back(indent + "    " + line);
    for (const std::string& line : formulas(plan.steps[i].after, notation)) lines.push_back(indent + "    -> " + line);
    if (!step.degenerate.empty()) lines.push_back(indent + "  degenerate: " + step.degenerate);
    if (step.branches > 1) indent += "  ";
  }
  return lines;
}

}  // namespace qvgen::application
