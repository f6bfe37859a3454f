// SPDX-License-Identifier: MIT
#include "exact/named_constant.h"

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>
#include <gtest/gtest.h>

namespace qvgen::exact {
namespace {

cln::cl_R root(int n) { return cln::sqrt(cln::cl_float(n, cln::float_format(100))); }
cln::cl_R pi() { return cln::pi(cln::float_format(100)); }
double off(const std::string& name, const cln::cl_R& value) {
  return cln::double_approx(cln::abs(cln::cl_float(*named_value(name), cln::float_format(100)) - value));
}

TEST(NamedConstant, NamesSayTheValue) {
  for (const cln::cl_R& value : {root(2), cln::cl_R(-root(3)), cln::cl_R(root(5) / 1000000)})
    EXPECT_LT(off(name_of_number(value), value), 1e-59);
}

TEST(NamedConstant, AnglesAreNamedByWhatTheyWereMeantAs) {
  EXPECT_EQ(name_of_angle(pi() / 6), "turn(1/6)");
  EXPECT_EQ(name_of_angle(cln::cl_RA(15708) / 10000), "angle(3927/2500)");
  EXPECT_LT(off("turn(1/6)", pi() / 6), 1e-59);
  EXPECT_LT(off(name_of_angle(root(2)), root(2)), 1e-59);
}

TEST(NamedConstant, SymbolsOfADescriptionAreNone) {
  for (const char* name : {"l1", "theta1", "turn", "angle", "number", "value(l1/l2)", "atan2(3/5,4/5)"})
    EXPECT_FALSE(named_value(name)) << name;
}

TEST(NamedConstant, RationalsAreFoundWhereTheyAreShort) {
  EXPECT_EQ(rational_near(cln::cl_float(cln::cl_RA(28949) / 100000, cln::float_format(100))),
            cln::cl_RA(28949) / 100000);
  EXPECT_FALSE(rational_near(root(2)));
}

}  // namespace
}  // namespace qvgen::exact
