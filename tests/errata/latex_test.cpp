// SPDX-License-Identifier: MIT
// Reading of what is printed in LaTeX.
#include <stdexcept>

#include <gtest/gtest.h>

#include "transcription.h"
#include "value.h"

namespace qvgen::test::sources {
namespace {

double value(const std::string& text, const Known& known = {}, double sign = 1) {
  return std::get<double>(value_of(read_latex(text).at(0), known, sign));
}

TEST(Latex, Numbers) {
  EXPECT_DOUBLE_EQ(value("1 - 2 \\cdot 3"), -5);
  EXPECT_DOUBLE_EQ(value("\\frac{1}{4}(3 + 5)2"), 4);
  EXPECT_DOUBLE_EQ(value("-3^2"), -9);
  EXPECT_DOUBLE_EQ(value("\\sqrt{9}\\,[1 + 1]"), 6);
  EXPECT_DOUBLE_EQ(value("6/2 + 1"), 4);
  EXPECT_DOUBLE_EQ(value("2 \\mp 1", {}, 1), 1);
  EXPECT_DOUBLE_EQ(value("2 \\mp 1", {}, -1), 3);
}

TEST(Latex, AnglesAndWhatIsOfThem) {
  const Known known{{"theta1", 0.3}, {"theta4", 0.7}, {"theta6", -1.1}, {"c", 5.0}, {"d4", 2.0}};
  EXPECT_DOUBLE_EQ(value("\\cos \\bar{\\theta}_{4-6}", known), std::cos(0.9));
  EXPECT_DOUBLE_EQ(value("\\cos \\bar{\\theta}_{(6-4)}", known), std::cos(0.9));
  EXPECT_DOUBLE_EQ(value("\\sin \\frac{1}{2} \\theta_1", known), std::sin(0.15));
  EXPECT_DOUBLE_EQ(value("\\sin(\\theta_1/2)", known), std::sin(0.15));
  EXPECT_DOUBLE_EQ(value("\\sin^2 \\theta_1 + c^2 \\theta_1", known), 1);
  EXPECT_DOUBLE_EQ(value("d_4s\\theta_1c\\theta_4", known), 2 * std::sin(0.3) * std::cos(0.7));
  EXPECT_DOUBLE_EQ(value("c \\cos \\theta_1 - d_4 c_1", known), 3 * std::cos(0.3));
  EXPECT_DOUBLE_EQ(value("\\bar{s}_1 \\bar{c}_1", known), std::sin(0.3) / 2);
  EXPECT_DOUBLE_EQ(value("\\arctan 2(-1, 0)"), std::atan2(-1, 0));
}

TEST(Latex, VectorsQuaternionsAndPairs) {
  const Known known{{"omega1", Eigen::Vector3d(1, 2, 3)}, {"Z1", Eigen::Vector3d(Eigen::Vector3d::UnitZ())}};
  const Value cross = value_of(read_latex("{}^1\\omega_1 \\times 2 {}^1\\hat{Z}_1").at(0), known);
  EXPECT_TRUE(same(cross, Eigen::Vector3d(4, -2, 0)));
  const Value turned = value_of(read_latex("[0, \\langle 0, 0, 1 \\rangle] * \\omega_1").at(0), known);
  EXPECT_TRUE(same(turned, Eigen::Vector3d(-1, -2, 3)));
  const Tree pair = read_latex("([0, \\langle 1, 0, 0 \\rangle], \\langle 0, 2, 0 \\rangle)").at(0);
  EXPECT_TRUE(same(value_of(pair, {}), value_of(read_latex("T(y, 2)R(x, 3.141592653589793)").at(0), {})));
  EXPECT_FALSE(same(value_of(pair, {}), value_of(read_latex("T(y, 2)R(y, 3.141592653589793)").at(0), {})));
  const Value matrix = value_of(read_latex("\\begin{bmatrix} 1 & 2 \\\\ 3 & -4 \\end{bmatrix}").at(0), {});
  EXPECT_EQ(std::get<Eigen::MatrixXd>(matrix)(1, 1), -4);
}

TEST(Latex, NoNumberIsNotRight) {
  const double nan = std::nan("");
  EXPECT_FALSE(same(nan, 1.0));
  EXPECT_FALSE(same(nan, nan));
  EXPECT_FALSE(same(Eigen::Vector3d(0, nan, 0), Eigen::Vector3d(0, 0, 0)));
  EXPECT_FALSE(same(1.0, Eigen::Vector3d(1, 1, 1)));
}

TEST(Latex, AGeneralEquationAtAnIndex) {
  const std::vector<Tree> sides = read_latex("{}^{i+1}\\omega_{i+1} = q_i * I_{xx_{i+1}}", {2});
  EXPECT_EQ(plain_text(sides[0]), "omega3");
  EXPECT_EQ(plain_text(sides[1]), "q2*Ixx3");
  EXPECT_EQ(plain_text(read_latex("q_{i+1}")[0]), "q[i+1]");
}

TEST(Latex, FramesBeforeALetter) {
  const Notation frames{{}, true};
  EXPECT_EQ(plain_text(read_latex("{}^{0}_{1}T\\,{}_{2}^{1}T", frames)[0]), "T01*T12");
  EXPECT_EQ(plain_text(read_latex("{}^{0}P_{2} + {}^2\\omega_2", frames)[0]), "P02 + omega22");
  EXPECT_EQ(plain_text(read_latex("{}^{0}P_{2} + {}^2\\omega_2")[0]), "P2 + omega2");
}

TEST(Latex, WhatCannotBeReadIsRefused) {
  for (const char* text :
       {"", "1 +", "(1", "\\langle 1, 2", "\\frac{1}", "a = ", "1 )", "(1, 2, 3)", "\\unknown{"})
    EXPECT_THROW(read_latex(text), std::runtime_error) << text;
}

TEST(Latex, WhatHasNoMeaningIsRefused) {
  const Known known{{"v", Eigen::Vector3d(1, 2, 3)}};
  for (const char* text : {"v + 1", "v \\times 2", "\\sin(v)", "u", "\\langle v, 1, 2 \\rangle", "[1, 2]"})
    EXPECT_THROW(value_of(read_latex(text).at(0), known), std::domain_error) << text;
}

/// Everything that is transcribed, written and read again.
TEST(Latex, WrittenAndReadAgain) {
  for (const Chapter& chapter : transcriptions())
    for (const Section& section : chapter.sections)
      for (const Printed& equation : section.equations) {
        if (!is_judged(equation)) continue;
        const Notation notation{{}, section.frames};
        for (const Tree& side : read_latex(equation.latex, notation))
          EXPECT_EQ(plain_text(read_latex(latex(side), notation).at(0)), plain_text(side)) << equation.number;
      }
}

}  // namespace
}  // namespace qvgen::test::sources
