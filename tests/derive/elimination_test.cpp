// SPDX-License-Identifier: MIT
// Arms whose position is a quartic: no pose makes what is eliminated divide by zero.
#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"

namespace qvgen::derive::inverse {
namespace {

using GiNaC::ex;

/// Three axes through one point behind two skew ones, without a symbol; what stands behind them follows.
const char* const centre_at_joints_3_to_5 = R"toml(name = "skew"
title = "two skew joints before a spherical wrist"
[[joint]]
type = "revolute"
axis = ["2/7", "-3/7", "6/7"]
variable = "q1"
origin = ["5/7", 0, 0]
link = ["2/11", 0, "5/11"]
[[joint]]
type = "revolute"
axis = [0, 1, 0]
variable = "q2"
origin = [0, "-3/9", 0]
[[joint]]
type = "revolute"
axis = [0, "-5/13", "12/13"]
variable = "q3"
origin = ["3/7", 0, 0]
[[joint]]
type = "revolute"
axis = [-1, 0, 0]
variable = "q4"
[[joint]]
type = "revolute"
axis = ["8/17", "15/17", 0]
variable = "q5"
link = ["-4/9", "3/7", 0]
)toml";

const char* const sixth_joint = R"toml([[joint]]
type = "revolute"
axis = [0, 0, 1]
variable = "q6"
link = ["1/9", 0, 0]
)toml";

/// True if it is a quotient by something that is no number.
bool divides(const ex& value) {
  const bool quotient = GiNaC::is_a<GiNaC::power>(value) && value.op(1).info(GiNaC::info_flags::negative);
  if (quotient && !GiNaC::is_a<GiNaC::numeric>(value.op(0).evalf())) return true;
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (divides(value.op(i))) return true;
  return false;
}

void expect_no_quotient(const std::string& description) {
  const auto read = description::read_text(description, "skew.toml");
  ASSERT_TRUE(read.robot);
  const Derivation derivation = derive(*read.robot);
  ASSERT_TRUE(derivation.found);
  ASSERT_TRUE(derivation.plan.quartic());
  const symbolic::Program& target = derivation.plan.target;
  EXPECT_GT(target.outputs().size(), 0U);
  for (const auto& output : target.outputs()) EXPECT_FALSE(divides(output.value)) << output.name;
  for (const auto& step : target.steps()) EXPECT_FALSE(divides(step.value)) << step.name;
}

TEST(Elimination, DividesByNothingThatThePoseMakesZero) {
  expect_no_quotient(centre_at_joints_3_to_5);
  expect_no_quotient(std::string(centre_at_joints_3_to_5) + sixth_joint);
}

}  // namespace
}  // namespace qvgen::derive::inverse
