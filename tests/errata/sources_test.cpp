// SPDX-License-Identifier: MIT
// The sources' printed equations: none is left out, each is judged, what is said to be right instead is
// right.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "configurations.h"
#include "document.h"
#include "inverse_formulas.h"
#include "newton_euler_values.h"
#include "reference/dynamics.h"
#include "reference/load.h"
#include "reused_parts.h"
#include "verdict.h"

namespace qvgen::test::sources {
namespace {

using Kind = Judgement::Kind;

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all = transcriptions();
  return all;
}

TEST(Sources, NoNumberIsLeftOut) {
  for (const Chapter& chapter : chapters()) {
    std::set<std::string> numbers;
    for (const Section& section : chapter.sections)
      for (const Printed& equation : section.equations) numbers.insert(equation.number);
    for (int i = 1; i <= chapter.count; ++i)
      EXPECT_EQ(numbers.count(chapter.prefix + std::to_string(i)), 1U) << chapter.prefix << i;
  }
}

TEST(Sources, WhatIsNotRightHasARightForm) {
  for (const Chapter& chapter : chapters())
    for (const Section& section : chapter.sections) {
      const std::vector<Judgement>& judgements = judgements_of(section);
      for (std::size_t i = 0; i < judgements.size(); ++i) {
        const Printed& equation = section.equations[i];
        const bool wrong = judgements[i].kind == Kind::wrong || judgements[i].kind == Kind::meaningless;
        if (judgements[i].kind == Kind::words) {
          EXPECT_FALSE(equation.right.empty()) << section.title << " " << equation.number;
          continue;
        }
        EXPECT_EQ(wrong, !equation.right.empty())
            << section.title << " " << equation.number << " " << equation.latex;
        EXPECT_EQ(wrong, judgements[i].corrected)
            << section.title << " " << equation.number << " " << equation.right;
      }
    }
}

/// A judge that calls everything right would be no use: with the last side's sign changed no equation holds.
TEST(Sources, TheOppositeOfARightEquationIsWrong) {
  int judged = 0;
  for (const Chapter& chapter : chapters())
    for (Section section : chapter.sections) {
      const std::vector<Judgement>& judgements = judgements_of(section);
      for (std::size_t i = 0; i < judgements.size(); ++i) {
        if (judgements[i].kind != Kind::right || !section.equations[i].indices.empty()) continue;
        const Value value = value_of(judgements[i].sides[0], configurations(section).at(0));
        const bool number = value.index() == 0 && std::get<double>(value) != 0;
        if (!number) continue;
        const std::vector<Tree>& sides = judgements[i].sides;
        section.equations[i].latex = latex(sides[0]) + " = -(" + latex(sides.back()) + ")";
        section.equations.resize(i + 1);
        EXPECT_EQ(judge(section)[i].kind, Kind::wrong) << section.equations[i].latex;
        ++judged;
        break;  // one of each section: the others are judged in the same way
      }
    }
  EXPECT_GT(judged, 30);
}

/// Numbers only, as the judged formulas have them.
reference::Values numbers_of(const Known& known) {
  reference::Values values;
  for (const auto& [name, value] : known)
    if (const double* number = std::get_if<double>(&value)) values[name] = *number;
  for (int i = 1; i <= 6; ++i) {
    const std::string digit = std::to_string(i);
    const auto angle = values.find("theta" + digit);
    if (angle == values.end()) continue;
    values["c" + digit] = std::cos(angle->second);
    values["s" + digit] = std::sin(angle->second);
  }
  return values;
}

bool alike(double a, double b) { return std::isnan(a) ? std::isnan(b) : std::abs(a - b) < 1e-9; }

/// Both at one configuration: each of the printed one's two values is one of the other's; neither is real
/// where the other is not.
void expect_same(const Tree& printed, const Formula& formula, const Known& known) {
  reference::Values values = numbers_of(known);
  std::vector<double> judged;
  for (const double first : {1.0, -1.0})
    for (const double second : {1.0, -1.0}) {
      values["pm"] = first;
      values["pm2"] = second;
      judged.push_back(value_of(formula.printed, values));
    }
  for (const double sign : {1.0, -1.0}) {
    const double read = std::get<double>(value_of(printed, known, sign));
    EXPECT_TRUE(std::any_of(judged.begin(), judged.end(), [&](double x) { return alike(x, read); }))
        << formula.number << ": " << read;
  }
}

/// The arms whose joints' equations are transcribed twice.
std::vector<Arm> sources_with_joints() {
  std::vector<Arm> arms = load_inverse_formulas("thesis_inverse.toml");
  for (const Arm& arm : load_inverse_formulas("paden_kahan_inverse.toml")) arms.push_back(arm);
  return arms;
}

/// An equation that solves for a joint under a name that the arm does not have counts as its right form, and
/// so does the definition of a name.
std::vector<Tree> sides_of(const Printed& equation, const Arm& arm) {
  std::vector<Tree> sides = read_latex(equation.latex);
  if (equation.right.empty()) return sides;
  std::vector<Tree> right = read_latex(equation.right);
  const bool joint = std::any_of(arm.formulas.begin(), arm.formulas.end(), [&](const Formula& f) {
    return f.number == equation.number && f.of == plain_text(right[0]);
  });
  return joint || equation.local ? right : sides;
}

int compare_joint_equations(const Section& section, const Arm& arm) {
  std::vector<Known> known = configurations(section);
  int compared = 0;
  for (const Printed& equation : section.equations) {
    if (!is_judged(equation)) continue;
    const std::vector<Tree> sides = sides_of(equation, arm);
    const auto formula = std::find_if(arm.formulas.begin(), arm.formulas.end(), [&](const Formula& f) {
      return f.number == equation.number && f.of == plain_text(sides[0]);
    });
    if (formula != arm.formulas.end()) {
      for (const Known& each : known) expect_same(sides.back(), *formula, each);
      ++compared;
    } else if (equation.local) {
      for (Known& each : known) each[plain_text(sides[0])] = value_of(sides.back(), each);
    }
  }
  return compared;
}

/// The equations that solve for a joint are transcribed twice, in the notation of print and as what is judged
/// at all solutions: both have the same values.
TEST(Sources, JointEquationsAreThoseThatAreJudged) {
  int compared = 0;
  const std::vector<Arm> arms = sources_with_joints();
  for (const Arm& arm : arms) compared += static_cast<int>(arm.formulas.size());
  for (const Chapter& chapter : chapters())
    for (const Section& section : chapter.sections) {
      if (!section.inverse) continue;
      const auto arm =
          std::find_if(arms.begin(), arms.end(), [&](const Arm& a) { return a.robot == section.robot; });
      ASSERT_NE(arm, arms.end()) << section.robot;
      compared -= compare_joint_equations(section, *arm);
    }
  EXPECT_EQ(compared, 0);
}

/// The values of chapter 5 by another recursion: the reference's.
TEST(Sources, TorquesAreTheReferences) {
  const std::string file = QVGEN_SOURCE_DIR "/generator/robots/ns_arm.toml";
  const reference::Chain chain = reference::load(file);
  const Eigen::Vector3d q(0.3, -1.1, 0.6);
  const Eigen::Vector3d qd(1.2, 0.4, -0.7);
  const Eigen::Vector3d qdd(-0.5, 0.9, 1.3);
  const Known known = newton_euler_values(chain, {{"g", 9.81}}, q, qd, qdd);
  const Eigen::VectorXd expected = reference::inverse_dynamics(chain, q, qd, qdd);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(std::get<double>(known.at("tau" + std::to_string(i + 1))), expected[i], 1e-12);
}

std::string content(const std::string& name) {
  std::ifstream file(QVGEN_SOURCE_DIR "/tests/errata/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Sources, TheDocumentsAreFresh) {
  const std::vector<Part>& judged = judged_parts();
  const char* const how = "to update them: qvgen_judge_sources tests/errata";
  EXPECT_TRUE(content("printed_equations.md") == markdown(judged)) << how;
  EXPECT_TRUE(content("printed_equations.tex") == latex_document(judged)) << how;
}

}  // namespace
}  // namespace qvgen::test::sources
