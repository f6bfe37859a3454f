// SPDX-License-Identifier: MIT
#include "emit/c/single_precision.h"

#include <gtest/gtest.h>

namespace qvgen::emit::c {
namespace {

/// 1e-7 is 2^-23.25, of 52 digits; so many of 23 are 2^-10.28.
TEST(SinglePrecision, BoundsOfRoundingHaveAsManyDigits) {
  EXPECT_EQ(in_double_precision("a < digits(1e-7) * my_digits(2)"), "a < 1e-7 * my_digits(2)");
  EXPECT_EQ(in_single_precision("a < digits(1e-7) * b"), "a < 8.01e-04f * b");
  EXPECT_EQ(in_single_precision("digits(0x1p-100)"), in_single_precision("0x1p-44"));
  EXPECT_EQ(in_single_precision("range(1e50)"), "1.61e+06f");
}

TEST(SinglePrecision, TypesFunctionsAndLimits) {
  EXPECT_EQ(in_single_precision("const double a = sqrt(fabs(x)) + atan2(y, x);"),
            "const float a = sqrtf(fabsf(x)) + atan2f(y, x);");
  EXPECT_EQ(in_single_precision("{-HUGE_VAL, DBL_EPSILON, DBL_MAX}"), "{-HUGE_VALF, FLT_EPSILON, FLT_MAX}");
  EXPECT_EQ(in_single_precision("double_angle = cosine + my_sin + sincos;"),
            "double_angle = cosine + my_sin + sincos;");
}

TEST(SinglePrecision, LiteralsAreTheFloatOfTheirDouble) {
  EXPECT_EQ(in_single_precision("1.0 0.1 2. .5 1e-3 1.5e+2 0x1.8p1"),
            "1.0f 0.1f 2.0f 0.5f 0.001f 150.0f 3.0f");
  EXPECT_EQ(in_single_precision("6.283185307179586476925"), "6.2831855f");
  // Rounded twice, as C++ rounds Scalar(1.00000005960464484): the double next to the middle of two floats is
  // the middle.
  EXPECT_EQ(in_single_precision("1.000000059604644775390626"), "1.0f");
  EXPECT_EQ(in_single_precision("q[10] + 3 + 0x1F - a1.b"), "q[10] + 3 + 0x1F - a1.b");
  EXPECT_EQ(in_single_precision("x-1.0-y"), "x-1.0f-y");
}

TEST(SinglePrecision, OtherLanguagesGetTheNumbersAlone) {
  EXPECT_EQ(with_single_numbers("const double a = 6.283185307179586476925 * sqrt(x) + 2.;"),
            "const double a = 6.2831855 * sqrt(x) + 2.0;");
  EXPECT_EQ(with_single_numbers("digits(1e-7) range(1e50) 0x1.1a62633145c07p-54 DBL_EPSILON"),
            "8.01e-04 1.61e+06 -4.371139e-08 DBL_EPSILON");
}

TEST(SinglePrecision, WhatIsNoCodeStays) {
  const char* const text = "// sin(double) 1.0\n/* 2.0 */ #include <math.h>\n\"1.0 double\"\n#if 1.0\n";
  EXPECT_EQ(in_single_precision(text), text);
}

TEST(SinglePrecision, NumbersBeyondFloatAreRefused) {
  EXPECT_THROW(in_single_precision("1e300"), std::runtime_error);
  EXPECT_THROW(in_single_precision("1e-300"), std::runtime_error);
  EXPECT_EQ(in_single_precision("0.0 0e5"), "0.0f 0.0f");
}

}  // namespace
}  // namespace qvgen::emit::c
