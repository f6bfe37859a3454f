// SPDX-License-Identifier: MIT
// Printed equations that solve for a joint: right forms proved right, the judge itself.
#include "inverse_formulas.h"

#include <gtest/gtest.h>

namespace qvgen::test::sources {
namespace {

TEST(InverseFormulas, TheRightFormsAreRight) {
  for (const char* file : {"thesis_inverse.toml", "planar_3r_inverse.toml", "paden_kahan_inverse.toml"}) {
    for (const Arm& arm : load_inverse_formulas(file)) {
      const Judge judge(arm, inverse_of(arm.robot));
      for (std::size_t i = 0; i < arm.formulas.size(); ++i) {
        const Verdict verdict = judge.formula(i, arm.formulas[i].right);
        EXPECT_TRUE(verdict.right()) << arm.robot << " " << arm.formulas[i].number << ": "
                                     << arm.formulas[i].right.written() << ": " << verdict.text();
      }
    }
  }
}

/// The judge itself: verdicts that one can see.
TEST(InverseFormulas, VerdictsOfPlainCases) {
  const Arm arm{"rr_planar", "", {{"", "theta2", {}, {}, ""}}};
  const Judge judge(arm, inverse_of("rr_planar"));
  const std::string cosine = "(px^2 + py^2 - l1^2 - l2^2)/(2*l1*l2)";
  EXPECT_EQ(judge.formula(0, {{}, "pm*acos(" + cosine + ")"}).text(), "right");
  EXPECT_EQ(judge.formula(0, {{}, "acos(" + cosine + ")"}).text(), "right iff theta2 > 0");
  EXPECT_EQ(judge.formula(0, {{}, "sign(px*py)*acos(" + cosine + ")"}).text().substr(0, 10), "right for ");
  EXPECT_EQ(judge.formula(0, {{}, "2*pm*acos(" + cosine + ")"}).text(), "wrong");
  EXPECT_EQ(judge.formula(0, {{}, "pm*pm2*acos(pm2*" + cosine + ")"}).text(),
            "right with one sign, which it does not tell");
}

}  // namespace
}  // namespace qvgen::test::sources
