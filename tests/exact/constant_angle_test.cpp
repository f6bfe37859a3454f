// SPDX-License-Identifier: MIT
#include "exact/constant_angle.h"

#include <gtest/gtest.h>

#include "exact/point.h"

namespace qvgen::exact {
namespace {

Number ratio(long a, long b) { return Number(cln::cl_RA(a) / b); }

TEST(ConstantAngle, ItsNameSaysSineAndCosine) {
  for (const CosineSine& value :
       {CosineSine{ratio(3, 5), ratio(-4, 5)}, CosineSine{Number::root(2) / 2, -(Number::root(2) / 2)},
        CosineSine{ratio(-1, 3), Number::root(8) / 3},
        CosineSine{(Number::root(6) - Number::root(2)) / 4, (Number::root(6) + Number::root(2)) / 4}})
    EXPECT_EQ(constant_angle(constant_angle(value)), value);
  EXPECT_EQ(constant_angle({ratio(4, 5), ratio(3, 5)}), "atan2(3/5,4/5)");
  EXPECT_EQ(constant_angle(std::string("theta1")), std::nullopt);
}

TEST(ConstantAngle, SumsWithPartsOfATurnAreExact) {
  const std::string name = constant_angle({ratio(4, 5), ratio(3, 5)});
  EXPECT_EQ(value_of({{{name, 1}}, cln::cl_RA(1) / 2}), (CosineSine{ratio(-3, 5), ratio(4, 5)}));
  EXPECT_EQ(value_of({{{name, -2}}, 0}), (CosineSine{ratio(7, 25), ratio(-24, 25)}));
  EXPECT_EQ(value_of({{{name, 1}, {"theta1", 1}}, 0}), std::nullopt);
  EXPECT_EQ(value_of({{{name, 1}}, cln::cl_RA(1) / 9}), std::nullopt);
}

TEST(ConstantAngle, StandsBesideAVariableAtAPoint) {
  const ExactPoint point(1);
  const Angle theta{{{"theta1", 1}}, 0};
  const Angle sum{{{"theta1", 1}, {constant_angle({ratio(4, 5), ratio(3, 5)}), 1}}, 0};
  EXPECT_EQ(point.sine(sum), ratio(4, 5) * point.sine(theta) + ratio(3, 5) * point.cosine(theta));
}

TEST(ConstantAngle, RadiansToTheLastDigit) {
  const Number angle(radians({ratio(-4, 5), ratio(3, 5)}));
  EXPECT_EQ(angle.to_double(), 2.498091544796509);  // pi - atan(3/4)
  const auto sum = radians(Angle{{{constant_angle({ratio(-4, 5), ratio(3, 5)}), -1}}, 1});
  ASSERT_TRUE(sum);
  EXPECT_EQ(Number(*sum).to_double(), 0.6435011087932844);  // atan(3/4)
  EXPECT_FALSE(radians(Angle{{{"theta1", 1}}, 1}));
}

}  // namespace
}  // namespace qvgen::exact
