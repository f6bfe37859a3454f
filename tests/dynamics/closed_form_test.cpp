// SPDX-License-Identifier: MIT
// The joint forces of the spherical arm (RRP) against the printed equations (5.47)-(5.49), term by term.
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "dag/evaluate.h"
#include "description/reader.h"
#include "emit/math/dynamics_closed_form.h"
#include "exact/point.h"

namespace qvgen::emit {
namespace {

using exact::Number;

class PrintedTerms : public testing::Test {
 protected:
  PrintedTerms() {
    const auto read = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/ns_arm.toml");
    for (const ForceTerm& term : dynamics_closed_form(read.robot.value()))
      derived_[{term.joint + 1, term.motion}] = dag::evaluate<Number>(term.coefficient, point_).front();
  }
  Number symbol(const std::string& name) const { return point_.symbol(name); }
  /// The derived coefficient; terms that are not derived are zero.
  Number derived(std::size_t joint, const std::string& motion) const {
    const auto place = derived_.find({joint, motion});
    return place == derived_.end() ? Number(0) : place->second;
  }

  const exact::ExactPoint point_{3};
  const exact::Angle theta2_{{{"theta2", 1}}, 0};
  const Number s_ = point_.sine(theta2_), c_ = point_.cosine(theta2_), half_ = Number(1) / Number(2);
  const Number d2_ = symbol("d2"), d3_ = symbol("d3"), l3_ = symbol("l3"), m2_ = symbol("m2"),
               m3_ = symbol("m3"), g_ = symbol("gravity");
  const Number quadratic_ = m3_ * (half_ * half_ * l3_ * l3_ - l3_ * d3_ + d3_ * d3_);
  const Number sum_ = symbol("Ixx2") + symbol("Ixx3") - symbol("Iyy2") - symbol("Izz3") + quadratic_;
  const Number lever_ = half_ * l3_ - d3_;
  std::map<std::pair<std::size_t, std::string>, Number> derived_;
};

/// (5.47) closes the bracket of the first acceleration too early: the two terms behind it belong to it as
/// well.
TEST_F(PrintedTerms, FirstJointHoldsButForTheBracketOfItsAcceleration) {
  const Number inside = symbol("Izz1") + half_ * half_ * m2_ * d2_ * d2_ +
                        s_ * s_ * (symbol("Ixx2") + symbol("Ixx3") + quadratic_);
  const Number behind = c_ * c_ * (symbol("Iyy2") + symbol("Izz3"));
  EXPECT_EQ(derived(1, "theta1''"), inside + behind + m3_ * d2_ * d2_);
  EXPECT_NE(derived(1, "theta1''"), inside);
  EXPECT_EQ(derived(1, ""), Number(0));  // as printed, c^2 (Iyy2 + Izz3) would stand here
  EXPECT_EQ(derived(1, "theta2''"), d2_ * m3_ * c_ * lever_);
  EXPECT_EQ(derived(1, "d3''"), -d2_ * m3_ * s_);
  EXPECT_EQ(derived(1, "theta1'*theta2'"), Number(2) * s_ * c_ * sum_);
  EXPECT_EQ(derived(1, "theta2'^2"), -d2_ * m3_ * s_ * lever_);
  EXPECT_EQ(derived(1, "theta2'*d3'"), Number(-2) * d2_ * m3_ * c_);
  EXPECT_EQ(derived(1, "theta1'*d3'"), m3_ * s_ * s_ * (Number(2) * d3_ - l3_));
}

TEST_F(PrintedTerms, SecondJointHolds) {
  EXPECT_EQ(derived(2, "theta1''"), d2_ * m3_ * c_ * lever_);
  EXPECT_EQ(derived(2, "theta2''"), symbol("Izz2") + symbol("Iyy3") + quadratic_);
  EXPECT_EQ(derived(2, "theta1'^2"), -s_ * c_ * sum_);
  EXPECT_EQ(derived(2, "theta2'*d3'"), m3_ * (Number(2) * d3_ - l3_));
  EXPECT_EQ(derived(2, ""), g_ * m3_ * s_ * lever_);
}

TEST_F(PrintedTerms, ThirdJointHolds) {
  EXPECT_EQ(derived(3, "theta1''"), -d2_ * m3_ * s_);
  EXPECT_EQ(derived(3, "d3''"), m3_);
  EXPECT_EQ(derived(3, "theta1'^2"), m3_ * s_ * s_ * lever_);
  EXPECT_EQ(derived(3, "theta2'^2"), m3_ * lever_);
  EXPECT_EQ(derived(3, ""), g_ * m3_ * c_);
}

/// Seven, five and five terms, and no others.
TEST_F(PrintedTerms, NothingElseStandsInTheForces) { EXPECT_EQ(derived_.size(), 17U); }

}  // namespace
}  // namespace qvgen::emit
