// SPDX-License-Identifier: MIT
#include "emit/math/describe.h"

#include "derive/inverse/inverse.h"
#include "emit/math/vocabulary.h"

namespace qvgen::emit {

using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

namespace {

std::string kind_name(Kind kind) {
  switch (kind) {
    case Kind::circle:
      return "line or circle meets circle";
    case Kind::free_circle:
      return "line or circle meets circle";
    case Kind::factored:
      return "line meets circle, its discriminant in factors";
    case Kind::opposite:
      return "two opposite directions";
    case Kind::pair:
      return "turn of one known vector into another";
    case Kind::root:
      return "foot of the perpendicular and square root";
    case Kind::slides:
      return "two slides by a linear and a quadratic equation";
    case Kind::linear:
      return "linear";
    case Kind::line:
      return "linear, with a divisor that may vanish";
    case Kind::conic:
      return "conic meets circle (quartic)";
    case Kind::slide_turn:
      return "turn and slide by a linear equation and a distance (quartic)";
    case Kind::require:
      return "condition";
    case Kind::reach:
      return "a choice within reach";
    case Kind::half:
      return "half angle";
    case Kind::polish:
      return "Newton steps";
    case Kind::right_wrist:
      return "wrist with right angles, half-angle form";
    case Kind::oblique_wrist:
      return "wrist with oblique axes, half-angle form";
  }
  return {};
}

std::string branches(const Step& step) {
  return step.branches == 1
             ? "one value"
             : std::to_string(step.branches) + (step.is_quartic() ? " values at most" : " values");
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

namespace {

/// How the block's result follows from its inputs.
std::string solution(const Step& step, bool latex) {
  const auto both = [&](const char* text, const char* typeset) {
    return std::string(latex ? typeset : text);
  };
  switch (step.kind) {
    case Kind::circle:
    case Kind::free_circle:
      return both("phi = +-2*atan2(sqrt(low), sqrt(high))",
                  "\\varphi = \\pm 2\\,\\mathrm{atan2}(\\sqrt{\\mathrm{low}}, \\sqrt{\\mathrm{high}})") +
             (step.kind == Kind::circle
                  ? ""
                  : both(", from the direction (x, y)", "\\text{ from the direction } (x, y)"));
    case Kind::factored:
      return both("phi = +-atan2(sqrt(low*high), rhs), from the direction (x, y)",
                  "\\varphi = \\pm\\mathrm{atan2}(\\sqrt{\\mathrm{low}\\,\\mathrm{high}}, "
                  "\\mathrm{rhs})\\text{ from the direction } (x, y)");
    case Kind::opposite:
      return both("phi = atan2(y, x) or atan2(-y, -x)", "\\varphi = \\mathrm{atan2}(\\pm y, \\pm x)") +
             (step.unit ? "" : both(", r = +-sqrt(x^2 + y^2)", ",\\ r = \\pm\\sqrt{x^2 + y^2}"));
    case Kind::pair:
      return both("phi = atan2(y, x)", "\\varphi = \\mathrm{atan2}(y, x)");
    case Kind::root:
      return both("r = +-sqrt(square)", "r = \\pm\\sqrt{\\mathrm{square}}");
    case Kind::line:
      if (step.has_input("divisor"))
        return both("r = rhs/divisor", "r = \\frac{\\mathrm{rhs}}{\\mathrm{divisor}}");
      return both("r = (x*rhs_x + y*rhs_y)/(x^2 + y^2)",
                  "r = \\frac{x\\,\\mathrm{rhs}_x + y\\,\\mathrm{rhs}_y}{x^2 + y^2}");
    case Kind::slides:
      return both("a*r_1 - b*r_2 = k, r_1^2 + 2*g*r_1 - r_2^2 - 2*f*r_2 + gap = 0",
                  "0 = a r_1 - b r_2 - k = r_1^2 + 2 g r_1 - r_2^2 - 2 f r_2 + \\mathrm{gap}");
    case Kind::conic:
      return both("xx*cos(phi)^2 + xy*cos(phi)*sin(phi) + yy*sin(phi)^2 + x*cos(phi) + y*sin(phi) + one = 0",
                  "0 = \\mathrm{xx} \\cos^2\\varphi + \\mathrm{xy} \\cos\\varphi \\sin\\varphi + "
                  "\\mathrm{yy} \\sin^2\\varphi + x \\cos\\varphi + y \\sin\\varphi + \\mathrm{one}");
    case Kind::slide_turn:
      return both(
          "divisor*r = level + l_x*cos(phi) + l_y*sin(phi), r^2 + 2*h*r + mean + m_x*cos(phi) + m_y*sin(phi) "
          "= 0",
          "\\mathrm{divisor}\\,r - \\mathrm{level} - l_x \\cos\\varphi - l_y \\sin\\varphi = 0 = r^2 + 2 h r "
          "+ \\mathrm{mean} + m_x \\cos\\varphi + m_y \\sin\\varphi");
    case Kind::require:
      return both("|residual| <= tolerance*scale",
                  "|\\mathrm{residual}| \\le \\mathrm{tolerance} \\cdot \\mathrm{scale}");
    case Kind::reach:
      return both("phi: inner <= |point + offset turned by phi|^2 <= outer",
                  "\\varphi:\\ \\mathrm{inner} \\le |\\mathrm{point} + e^{i\\varphi}\\,\\mathrm{offset}|^2 "
                  "\\le \\mathrm{outer}");
    case Kind::linear:
    case Kind::half:
    case Kind::polish:
    case Kind::right_wrist:
    case Kind::oblique_wrist:
      return {};
  }
  return {};
}

/// The wrist's angles; the second solution is the first one with the middle joint turned the other way.
std::vector<std::string> wrist_solution(const LoweredPlan& plan, const Step& step, const Vocabulary& words,
                                        bool latex) {
  std::vector<std::string> angles;
  for (const std::string& turn : step.turns) angles.push_back(words(turn));
  const std::string plus = latex ? "\\arg u + \\arg v" : "arg u + arg v";
  const std::string minus = latex ? "\\arg u - \\arg v" : "arg u - arg v";
  const std::string ratio = plan.plan.wrist.middle_swapped ? "(|u|, |v|)" : "(|v|, |u|)";
  if (step.kind == Kind::oblique_wrist)
    return {latex ? "|u|^2 = \\cos^2\\tfrac{\\alpha+\\alpha'}{2} + \\sin\\alpha\\sin\\alpha' "
                    "\\sin^2\\tfrac{\\varphi}{2},\\ " +
                        angles[1] + " = \\pm\\varphi - \\delta"
                  : "|u|^2 = cosine_sum^2 + product*sin(phi/2)^2, " + angles[1] + " = +-phi - delta"};
  return {angles[0] + " = " + plus, angles[1] + " = " + (latex ? "2\\,\\mathrm{atan2}" : "2*atan2") + ratio,
          angles[2] + " = " + minus,
          latex ? "\\text{or } " + angles[0] + " + \\pi,\\ -" + angles[1] + ",\\ " + angles[2] + " + \\pi"
                : "or " + angles[0] + " + pi, -" + angles[1] + ", " + angles[2] + " + pi"};
}

/// Longer formulas say nothing to a reader.
constexpr std::size_t readable = 400;

class Description {
 public:
  Description(const LoweredPlan& plan, const std::vector<std::string>& variables, Notation notation)
      : plan_(plan),
        words_(plan.plan, variables, notation),
        notation_(notation),
        latex_(notation == Notation::latex),
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
      if (output.name == derive::inverse::size_square || output.name == "scale") continue;
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
    if (step.kind == Kind::half) {
      add("", "").formulas = formulas(plan_.steps[i].after, step);
      return;
    }
    Passage& passage = add(headline(step), step.equation);
    passage.formulas = formulas(plan_.steps[i].before, step);
    if (step.is_wrist()) {
      for (const std::string& line : wrist_solution(plan_, step, words_, latex_))
        passage.formulas.push_back(line);
    } else if (const std::string solved = solution(step, latex_); !solved.empty()) {
      passage.formulas.push_back(solved);
    }
    for (const std::string& line : formulas(plan_.steps[i].after, step)) passage.formulas.push_back(line);
    passage.degenerate = words_.sentence(step.degenerate);
    if (step.branches > 1) ++depth_;
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
    (notation == Notation::latex ? append_latex : append_text)(passage, lines);
  return lines;
}

}  // namespace qvgen::emit
