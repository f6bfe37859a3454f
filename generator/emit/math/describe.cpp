// SPDX-License-Identifier: MIT
#include "emit/math/describe.h"

#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "emit/math/vocabulary.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

using derive::inverse::LoweredPlan;
using derive::inverse::Step;

namespace {

std::string kind_name(const Step& step) {
  return std::visit([](const auto& kind) { return kind.title; }, step.kind);
}

std::string branches(const Step& step) {
  return step.branches == 1
             ? "one value"
             : std::to_string(step.branches) + (step.is_quartic() ? " values at most" : " values");
}

std::string headline(const Step& step) {
  return step.unknown + ": " + kind_name(step) + ", " + branches(step);
}

}  // namespace

std::vector<std::string> step_comment(const LoweredPlan& plan, std::size_t index) {
  const Step& step = plan.plan.steps[index];
  std::vector<std::string> lines = {headline(step) + ".", "From: " + step.equation + "."};
  if (!step.degenerate.empty()) lines.push_back("Degenerate: " + step.degenerate + ".");
  return lines;
}

namespace {

/// Longer formulas say nothing to a reader.
constexpr std::size_t readable = 400;

class Description {
 public:
  Description(const LoweredPlan& plan, const std::vector<std::string>& variables, Notation notation)
      : plan_(plan),
        words_(plan.plan, variables, notation),
        notation_(notation),
        latex_(notation.typeset),
        count_(std::to_string(variables.size())) {}

  std::vector<Passage> write() {
    Passage& whole =
        add(plan_.plan.structure + "; at most " + std::to_string(plan_.plan.capacity) + " solutions", "");
    whole.formulas = scheme();
    for (const std::string& line : formulas(plan_.target, {})) whole.formulas.push_back(line);
    if (plan_.plan.range_test.exists()) range_test();
    for (const std::size_t i : derive::inverse::order(plan_.plan, plan_.plan.quartic())) step(i);
    return std::move(passages_);
  }

 private:
  /// What is compared: the thesis's (1.22) and (1.23).
  [[nodiscard]] std::vector<std::string> scheme() const {
    if (latex_)
      return {"N_1 = ([w, \\langle a, b, c \\rangle], \\langle p_x, p_y, p_z \\rangle)",
              "M_i = Q_i Q_{i+1} \\dots Q_{" + count_ + "} = N_i = Q_{i-1}^{-1} \\dots Q_1^{-1} N_1"};
    return {"N_1 = ([w, <a, b, c>], <p_x, p_y, p_z>)",
            "M_i = Q_i Q_i+1 ... Q_" + count_ + " = N_i = Q_i-1^-1 ... Q_1^-1 N_1"};
  }

  [[nodiscard]] std::vector<std::string> formulas(const dag::Function& function, const Step& step) const {
    const auto name = [&](const std::string& symbol) { return words_(symbol, step); };
    std::vector<std::string> lines;
    for (const dag::Output& output : function.outputs) {
      // What tells noise from values is no part of the mathematics.
      if (output.name == names::size_square || output.name == "scale") continue;
      const std::string left = name(output.name);
      const std::string right = formula(function.graph, output.value, notation_, name);
      if (left != right && right.size() <= readable) lines.push_back(left + " = " + right);
    }
    return lines;
  }

  /// What tells before any branch that a pose is out of reach.
  void range_test() {
    const derive::inverse::RangeTest& test = plan_.plan.range_test;
    Passage& passage = add("Out of reach, before any branch: no " + test.unknown, test.equation);
    passage.formulas = formulas(plan_.range_test, {});
    passage.formulas.emplace_back(latex_ ? "\\left| \\left| \\mathrm{middle} - \\tfrac12 \\right| - "
                                           "\\sqrt{\\mathrm{swing}} \\right| > \\tfrac12"
                                         : "||middle - 1/2| - sqrt(swing)| > 1/2");
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.is<derive::inverse::kind::Half>()) {
      add("", "").formulas = formulas(plan_.steps[i].after, step);
      return;
    }
    Passage& passage = add(headline(step), step.equation);
    passage.formulas = formulas(plan_.steps[i].before, step);
    for (const std::string& line : solution(step)) passage.formulas.push_back(line);
    for (const std::string& line : formulas(plan_.steps[i].after, step)) passage.formulas.push_back(line);
    passage.degenerate = words_.sentence(step.degenerate);
    if (step.branches > 1) ++depth_;
  }

  /// How the block's result follows from its inputs.
  [[nodiscard]] std::vector<std::string> solution(const Step& step) const {
    std::vector<std::string> joints;
    if (const auto* wrist = step.wrist())
      for (const std::string& variable : wrist->variables) joints.push_back(words_(variable, step));
    const auto formulas = std::visit([&](const auto& kind) { return kind.solution(joints); }, step.kind);
    std::vector<std::string> lines;
    for (const derive::inverse::Formula& formula : formulas)
      lines.push_back(latex_ ? formula.latex : formula.text);
    return lines;
  }

  Passage& add(const std::string& title, const std::string& equation) {
    passages_.push_back({depth_, words_.sentence(title), words_.sentence(equation), {}, ""});
    return passages_.back();
  }

  const LoweredPlan& plan_;
  Vocabulary words_;
  Notation notation_;
  bool latex_;
  std::string count_;
  std::size_t depth_ = 0;
  std::vector<Passage> passages_;
};

void append_text(const Passage& passage, std::vector<std::string>& lines) {
  const std::string indent(2 * passage.depth, ' ');
  if (!passage.title.empty()) lines.push_back(indent + passage.title);
  if (!passage.equation.empty()) lines.push_back(indent + "  from: " + passage.equation);
  for (const std::string& formula : passage.formulas) lines.push_back(indent + "    " + formula);
  if (!passage.degenerate.empty()) lines.push_back(indent + "  degenerate: " + passage.degenerate);
}

void append_latex(const Passage& passage, std::vector<std::string>& lines) {
  const std::string indent(2 * passage.depth, ' ');
  if (!passage.title.empty()) lines.push_back("\\paragraph{" + passage.title + ".} " + passage.equation);
  if (!passage.formulas.empty()) {
    lines.emplace_back("\\begin{align*}");
    for (std::string formula : passage.formulas) {
      const std::size_t equals = formula.find(" = ");
      formula = equals == std::string::npos ? "& " + formula : formula.replace(equals, 3, " &= ");
      lines.push_back(indent + formula + " \\\\");
    }
    lines.emplace_back("\\end{align*}");
  }
  if (!passage.degenerate.empty()) lines.push_back("Degenerate: " + passage.degenerate + ".");
}

}  // namespace

std::vector<Passage> passages(const LoweredPlan& plan, const std::vector<std::string>& variables,
                              Notation notation) {
  return Description(plan, variables, notation).write();
}

std::vector<std::string> describe(const LoweredPlan& plan, const std::vector<std::string>& variables,
                                  Notation notation) {
  std::vector<std::string> lines;
  for (const Passage& passage : passages(plan, variables, notation))
    (notation.typeset ? append_latex : append_text)(passage, lines);
  return lines;
}

}  // namespace qvgen::emit
