// SPDX-License-Identifier: MIT
#include "emit/math/mathml.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using qvgen::emit::aligned_mathml;
using qvgen::emit::mathml;

TEST(Mathml, NamesIndicesAndPowers) {
  EXPECT_EQ(mathml("\\theta_{12}"), "<msub><mi>&#x3B8;</mi><mrow><mn>12</mn></mrow></msub>");
  EXPECT_EQ(mathml("\\mathrm{rhs}_x"), "<msub><mi>rhs</mi><mi>x</mi></msub>");
  EXPECT_EQ(mathml("{p_{y}}^2"),
            "<msup><mrow><msub><mi>p</mi><mrow><mi>y</mi></mrow></msub></mrow><mn>2</mn></msup>");
}

TEST(Mathml, FunctionsFractionsAndRoots) {
  EXPECT_EQ(mathml("\\tfrac12"), "<mfrac><mn>1</mn><mn>2</mn></mfrac>");
  EXPECT_EQ(mathml("\\frac{a}{b}"), "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>");
  EXPECT_EQ(mathml("\\sqrt{2}"), "<msqrt><mrow><mn>2</mn></mrow></msqrt>");
  EXPECT_NE(mathml("\\sin \\varphi").find("<mo>&#x2061;</mo>"), std::string::npos);
}

TEST(Mathml, TerminatingFractionsAreDecimals) {
  EXPECT_EQ(mathml("\\tfrac{203}{10000}"), "<mn>0.0203</mn>");
  EXPECT_EQ(mathml("\\tfrac{84}{125}"), "<mn>0.672</mn>");
  EXPECT_EQ(mathml("\\tfrac{203}{4318}"),
            "<mfrac><mrow><mn>203</mn></mrow><mrow><mn>4318</mn></mrow></mfrac>");
  EXPECT_EQ(mathml("1/20000*x"), "<mn>0.00005</mn><mo>&#x22C5;</mo><mi>x</mi>");
}

TEST(Mathml, WordsKeepTheirDistance) {
  EXPECT_EQ(mathml("\\text{vector of } N"), "<mtext>vector of&#xA0;</mtext><mi>N</mi>");
  EXPECT_EQ(mathml("\\text{ or } \\pi"), "<mtext>&#xA0;or&#xA0;</mtext><mi>&#x3C0;</mi>");
}

TEST(Mathml, LongSumsGoOnBelow) {
  std::string sum = "a";
  for (int i = 0; i < 30; ++i) sum += " + \\sin(\\theta_{1} - b)";
  const std::string table = aligned_mathml({"x = " + sum});
  std::size_t rows = 0;
  for (std::size_t at = table.find("<mtr>"); at != std::string::npos; at = table.find("<mtr>", at + 1))
    ++rows;
  EXPECT_GT(rows, 3U);
  EXPECT_EQ(aligned_mathml({"x = a"}).find("<mtr>"), aligned_mathml({"x = a"}).rfind("<mtr>"));
}

TEST(Mathml, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(mathml("\\unknown"), std::invalid_argument);
  EXPECT_THROW(mathml("a}"), std::invalid_argument);
  EXPECT_THROW(mathml("\\frac{a}{b"), std::invalid_argument);
  EXPECT_THROW(mathml("a & b"), std::invalid_argument);
}

}  // namespace
