// SPDX-License-Identifier: MIT
#include "emit/math/describe.h"

#include <algorithm>
#include <map>

#include "dag/rebuild.h"
#include "derive/inverse/names.h"
#include "derive/inverse/target.h"
#include "emit/math/describe_steps.h"
#include "emit/math/lines.h"
#include "emit/math/subproblems.h"
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
  Description(LoweredPlan plan, const std::vector<std::string>& variables, Notation notation)
      : plan_(std::move(plan)),
        words_(plan_.plan, variables, notation),
        notation_(notation),
        latex_(notation.typeset),
        count_(std::to_string(variables.size())) {
    count_roots(plan_.target);
    if (plan_.plan.range_test.exists()) count_roots(plan_.range_test);
    for (const auto& step : plan_.steps) {
      count_roots(step.before);
      count_roots(step.after);
    }
  }

  std::vector<Passage> write() {
    Passage& whole =
        add(plan_.plan.structure + "; at most " + std::to_string(plan_.plan.capacity) + " solutions", "");
    whole.formulas = scheme();
    for (const std::string& line : formulas(plan_.target, {})) whole.formulas.push_back(line);
    if (plan_.plan.range_test.exists()) range_test();
    return write_steps();
  }

  /// The steps, behind the passages that there are.
  std::vector<Passage> write_steps() {
    for (const std::size_t i : derive::inverse::order(plan_.plan, plan_.plan.quartic())) step(i);
    return std::move(passages_);
  }

  /// The steps behind the values that they take.
  std::vector<Passage> write_without_pose() {
    add("", "").formulas = formulas(plan_.target, {});
    return write_steps();
  }

 private:
  /// Describes what is compared: the thesis's (1.22) and (1.23), and what the names below are.
  [[nodiscard]] std::vector<std::string> scheme() const {
    std::vector<std::string> lines = names_of_pairs();
    const auto& steps = plan_.plan.steps;
    const bool by_vectors =
        std::any_of(steps.begin(), steps.end(), [](const Step& step) { return step.elements.of_vector(); });
    if (by_vectors) lines.insert(lines.end() - 1, names_of_vectors());
    return lines;
  }

  /// Describes the point that the first joints place: a wrist's, which `goal` is in the base frame, or the
  /// tool's.
  [[nodiscard]] std::string names_of_vectors() const {
    const auto& kept = plan_.plan.target_kept;
    const bool goal = std::any_of(kept.begin(), kept.end(),
                                  [](const std::string& name) { return name.rfind("goal", 0) == 0; });
    if (latex_)
      return std::string("\\langle N_{i5}, N_{i6}, N_{i7} \\rangle = \\text{vector of } N_i") +
             (goal ? " \\text{ with goal in place of } p" : "");
    return std::string("<N_i5, N_i6, N_i7> = vector of N_i") + (goal ? " with goal in place of p" : "");
  }

  [[nodiscard]] std::vector<std::string> names_of_pairs() const {
    if (latex_)
      return {"N_1 = ([w, \\langle a, b, c \\rangle], \\langle p_x, p_y, p_z \\rangle)",
              "M_i = Q_i Q_{i+1} \\dots Q_{" + count_ + "} = N_i = Q_{i-1}^{-1} \\dots Q_1^{-1} N_1",
              "\\bar{\\theta} = \\tfrac{1}{2} \\theta",
              "[N_{i1}, \\langle N_{i2}, N_{i3}, N_{i4} \\rangle] = \\text{quaternion of } N_i",
              "N_x, N_y, M_x, M_y = \\text{a point on both sides, across an axis}"};
    return {"N_1 = ([w, <a, b, c>], <p_x, p_y, p_z>)",
            "M_i = Q_i Q_i+1 ... Q_" + count_ + " = N_i = Q_i-1^-1 ... Q_1^-1 N_1",
            "[N_i1, <N_i2, N_i3, N_i4>] = quaternion of N_i",
            "N_x, N_y, M_x, M_y = a point on both sides, across an axis"};
  }

  /// Returns the radicand of a root, as it reads without a name; empty where a step's own angle or length
  /// stands in it.
  [[nodiscard]] std::string radicand(const dag::Graph& graph, const dag::Node& root) const {
    const auto name = [&](const std::string& symbol) { return words_(symbol); };
    const std::string text = formula(graph, root.operands[0], Notation::text, name);
    return text.find("result") == std::string::npos && text.find("phi") == std::string::npos ? text : "";
  }

  void count_roots(const dag::Function& function) {
    std::map<std::uint32_t, int> uses;
    for (const std::uint32_t id : dag::reachable(function))
      for (const dag::Edge& operand : function.graph.node(id).operands) ++uses[operand.node];
    for (const dag::Output& output : function.outputs) ++uses[output.value.node];
    for (const auto& [id, count] : uses)
      if (const dag::Node& node = function.graph.node(id); node.op == dag::Op::root)
        root_uses_[radicand(function.graph, node)] += count;
  }

  /// Roots that stand in several places have a name, defined above the first.
  [[nodiscard]] dag::Function with_named_roots(const dag::Function& function, const Step& step,
                                               std::vector<std::string>& lines) {
    return dag::rebuild(function, [&](const dag::Graph& from, const dag::Node& node,
                                      const std::vector<dag::Edge>& operands, dag::Graph& to) {
      const std::string of = node.op == dag::Op::root ? radicand(from, node) : "";
      if (of.empty() || root_uses_[of] < 2) return dag::copy_node(from, node, operands, to);
      const bool is_new = roots_.count(of) == 0;
      if (is_new) roots_[of] = "rho" + std::to_string(roots_.size() + 1);
      const auto name = [&](const std::string& symbol) { return words_(symbol, step); };
      if (is_new)
        lines.push_back(formula(roots_[of], notation_) + " = " +
                        formula(to, dag::copy_node(from, node, operands, to), notation_, name));
      return to.symbol(roots_[of]);
    });
  }

  [[nodiscard]] std::vector<std::string> formulas(const dag::Function& plain, const Step& step) {
    const auto name = [&](const std::string& symbol) { return words_(symbol, step); };
    std::vector<std::string> lines;
    const dag::Function function = with_named_roots(plain, step, lines);
    for (const dag::Output& output : function.outputs) {
      // The mathematics has no thresholds between noise and signal.
      if (output.name == names::size_square || output.name == "scale") continue;
      const std::string left = name(output.name);
      const std::string right = formula(function.graph, output.value, notation_, name);
      if (left != right && right.size() <= readable) lines.push_back(left + " = " + right);
    }
    return lines;
  }

  /// Describes the test that tells before any branch that a pose is out of reach.
  void range_test() {
    const derive::inverse::RangeTest& test = plan_.plan.range_test;
    Passage& passage = add("Out of reach, before any branch: no " + test.unknown, test.equation);
    dag::Function values = plan_.range_test;
    const auto is_zero = [&](const dag::Output& output) { return values.graph.is_zero(output.value); };
    const bool swings = std::erase_if(values.outputs, is_zero) == 0;
    passage.formulas = formulas(values, {});
    const char* text = swings ? "||middle - 1/2| - sqrt(swing)| > 1/2" : "|middle - 1/2| > 1/2";
    const char* typeset = swings ? "\\left| \\left| \\mathrm{middle} - \\tfrac12 \\right| - "
                                   "\\sqrt{\\mathrm{swing}} \\right| > \\tfrac12"
                                 : "\\left| \\mathrm{middle} - \\tfrac12 \\right| > \\tfrac12";
    passage.formulas.emplace_back(latex_ ? typeset : text);
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.is<derive::inverse::kind::Half>()) {
      add("", "").formulas = formulas(plan_.steps[i].after, step);
      return;
    }
    Passage& passage = add(headline(step), step.equation);
    passage.equation += elements(step.elements);
    passage.formulas = formulas(plan_.steps[i].before, step);
    for (const std::string& line : solution(step)) passage.formulas.push_back(line);
    for (const std::string& line : formulas(plan_.steps[i].after, step)) passage.formulas.push_back(line);
    passage.degenerate = words_.sentence(step.degenerate);
    if (step.branches > 1) ++depth_;
  }

  /// "; elements 5 and 7 of M_2 = N_2"
  [[nodiscard]] std::string elements(const derive::inverse::Elements& of) const {
    if (of.indices.empty()) return "";
    std::string text = of.indices.size() == 1 ? "; element " : "; elements ";
    for (std::size_t i = 0; i < of.indices.size(); ++i) {
      const bool last = i > 0 && i + 1 == of.indices.size();
      text += (i == 0 ? "" : last ? " and " : ", ") + std::to_string(of.indices[i]);
    }
    const std::string pair = std::to_string(plan_.plan.places.at(static_cast<std::size_t>(of.joint)) + 1);
    return text + " of " + (latex_ ? "$M_{" + pair + "} = N_{" + pair + "}$" : "M_" + pair + " = N_" + pair);
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

  LoweredPlan plan_;
  Vocabulary words_;
  std::map<std::string, int> root_uses_;      ///< by radicand
  std::map<std::string, std::string> roots_;  ///< their names
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
  for (const std::string& formula : passage.formulas)
    for (const std::string& line : formula_lines(formula, Notation::text))
      lines.push_back(indent + "    " + line);
  if (!passage.degenerate.empty()) lines.push_back(indent + "  degenerate: " + passage.degenerate);
}

void append_latex(const Passage& passage, std::vector<std::string>& lines) {
  const std::string indent(2 * passage.depth, ' ');
  if (!passage.title.empty()) lines.push_back("\\paragraph{" + passage.title + ".} " + passage.equation);
  if (!passage.formulas.empty()) {
    lines.emplace_back("\\begin{align*}");
    for (const std::string& formula : passage.formulas)
      for (const std::string& line : formula_lines(formula, Notation::latex)) lines.push_back(indent + line);
    lines.emplace_back("\\end{align*}");
  }
  if (!passage.degenerate.empty()) lines.push_back("Degenerate: " + passage.degenerate + ".");
}

}  // namespace

std::vector<Passage> passages(const derive::inverse::Derivation& derivation, Notation notation) {
  std::vector<std::string> variables;
  for (const model::Joint& joint : derivation.problem.moving.joints) variables.push_back(joint.variable);
  derive::inverse::Plan plan = derivation.plan;
  derive::inverse::read_unit_quaternion(plan.target);
  derive::inverse::read_unit_quaternion(plan.range_test.values);
  return Description(lower(plan), variables, notation).write();
}

std::vector<std::string> describe(const derive::inverse::Derivation& derivation, Notation notation) {
  std::vector<std::string> lines;
  std::vector<Passage> all = passages(derivation, notation);
  for (const Passage& passage : subproblem_passages(derivation, notation)) all.push_back(passage);
  for (const Passage& passage : all) (notation.typeset ? append_latex : append_text)(passage, lines);
  return lines;
}

std::vector<std::string> describe_steps(const LoweredPlan& plan, const std::vector<std::string>& variables,
                                        Notation notation) {
  std::vector<std::string> lines;
  for (const Passage& passage : Description(plan, variables, notation).write_without_pose())
    (notation.typeset ? append_latex : append_text)(passage, lines);
  return lines;
}

}  // namespace qvgen::emit
