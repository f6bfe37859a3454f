// SPDX-License-Identifier: MIT
#include "verdict.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "brackets.h"

namespace qvgen::test::sources {
namespace {

using Kind = Judgement::Kind;

constexpr double rounding = 1e-9;

/// Returns the error that is allowed: an example's numbers hold as far as they are printed.
double tolerance_of(const Section& section) { return std::max(rounding, section.numbers.tolerance); }

/// The largest difference of the first side and another; of a printed sign ±, the better one counts.
double error_of(const std::vector<Tree>& sides, const Known& known) {
  const Value left = value_of(sides[0], known);
  double error = 0;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const double plus = distance(left, value_of(sides[i], known, 1));
    error = std::max(error, std::min(plus, distance(left, value_of(sides[i], known, -1))));
  }
  return error;
}

double error_of(const std::vector<Tree>& sides, const std::vector<Known>& configurations) {
  double error = 0;
  for (const Known& known : configurations) error = std::max(error, error_of(sides, known));
  return error;
}

/// "0.31 where it is -0.52", of numbers.
std::string counterexample(const std::vector<Tree>& sides, const Known& known) {
  const Value left = value_of(sides[0], known);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Value right = value_of(sides[i], known);
    if (!same(left, right) && left.index() == 0 && right.index() == 0)
      return fmt::format("{:.3f} for {:.3f}", std::get<double>(right), std::get<double>(left));
  }
  return {};
}

std::vector<Tree> read(const Printed& equation, const std::string& latex, const Notation& notation) {
  try {
    return read_latex(latex, notation);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(equation.number + ": " + error.what() + " in " + latex);
  }
}

class SectionJudge {
 public:
  explicit SectionJudge(const Section& section) : section_(section), known_(configurations(section)) {
    if (section.inverse) variables_ = joint_variables(section);
  }

  Judgement judge(const Printed& equation) {
    Judgement result;
    if (!equation.evidence.empty()) {
      result.kind = Kind::words;
      return result;
    }
    if (!equation.excluded.empty() || !equation.definition.empty()) {
      result.kind = equation.excluded.empty() ? Kind::definition : Kind::excluded;
      return result;
    }
    result.sides = read(equation, equation.latex, {{}, section_.frames});
    if (is_variable(result.sides[0])) {
      result.kind = Kind::inverse;
    } else if (equation.local) {
      define(equation, result);
    } else {
      compare(equation, result);
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_variable(const Tree& tree) const {
    return std::find(variables_.begin(), variables_.end(), plain_text(tree)) != variables_.end();
  }

  void define(const std::vector<Tree>& sides) {
    for (Known& known : known_) known[plain_text(sides[0])] = value_of(sides.back(), known);
  }

  /// A name whose definition has no meaning gets the right one, so that what uses it is judged by itself.
  void define(const Printed& equation, Judgement& result) {
    result.kind = Kind::local;
    try {
      define(result.sides);
      return;
    } catch (const std::domain_error& trouble) {
      result.kind = Kind::meaningless;
      result.trouble = trouble.what();
    }
    if (equation.right.empty()) return;
    result.right = read(equation, equation.right, {{}, section_.frames});
    define(result.right);
    result.corrected = true;
    result.slips = differences(result.sides, result.right);
  }

  [[nodiscard]] double error(const Printed& equation, const std::string& latex) const {
    if (equation.indices.empty()) return error_of(read(equation, latex, {{}, section_.frames}), known_);
    double largest = 0;
    for (const int index : equation.indices)
      largest = std::max(largest, error_of(read(equation, latex, {index, section_.frames}), known_));
    return largest;
  }

  void compare(const Printed& equation, Judgement& result) const {
    try {
      result.error = error(equation, equation.latex);
      result.kind = result.error < tolerance_of(section_) ? Kind::right : Kind::wrong;
      if (result.kind == Kind::wrong && equation.indices.empty())
        result.counterexample = counterexample(result.sides, known_[0]);
    } catch (const std::domain_error& trouble) {
      result.kind = Kind::meaningless;
      result.trouble = trouble.what();
    }
    if (equation.right.empty()) return;
    result.right = read(equation, equation.right, {{}, section_.frames});
    try {
      result.corrected = error(equation, equation.right) < tolerance_of(section_);
    } catch (const std::domain_error&) {
      result.corrected = false;
    }
    result.slips = differences(result.sides, result.right);
    if (result.kind == Kind::wrong && result.slips.count("bracket") > 0 && result.slips.size() > 1)
      repair_brackets(result);
  }

  void repair_brackets(Judgement& result) const {
    std::vector<Tree> sides;
    for (std::size_t i = 0; i < result.sides.size(); ++i)
      sides.push_back(same_without_brackets(result.sides[i], result.right[i])
                          ? rebracketed(result.sides[i], result.right[i])
                          : result.sides[i]);
    result.brackets_alone = error_of(sides, known_);
  }

  const Section& section_;
  std::vector<Known> known_;
  std::vector<std::string> variables_;  ///< that the equations solve for
};

}  // namespace

std::vector<Judgement> judge(const Section& section) {
  SectionJudge judge(section);
  std::vector<Judgement> result;
  for (const Printed& equation : section.equations) result.push_back(judge.judge(equation));
  return result;
}

}  // namespace qvgen::test::sources
