// SPDX-License-Identifier: MIT
// Printed inverse kinematics of the sources: verdicts computed, right forms proved right, the table up to
// date.
#include "errata.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace qvgen::test::errata {
namespace {

const InverseUnderTest* robot_of(const std::string& name) {
  for (const InverseUnderTest& robot : inverses())
    if (robot.name == name) return &robot;
  return nullptr;
}

TEST(Errata, TheRightFormsAreRight) {
  for (const Source& source : sources()) {
    for (const Arm& arm : source.arms) {
      const InverseUnderTest* robot = robot_of(arm.robot);
      ASSERT_NE(robot, nullptr) << arm.robot;
      const Judge judge(arm, *robot);
      for (std::size_t i = 0; i < arm.quaternion.right.size(); ++i)
        EXPECT_TRUE(judge.quaternion(i, arm.quaternion.right).right())
            << arm.robot << " " << arm.quaternion.right[i];
      for (std::size_t i = 0; i < arm.formulas.size(); ++i) {
        const Verdict verdict = judge.formula(i, arm.formulas[i].right);
        EXPECT_TRUE(verdict.right()) << arm.robot << " " << arm.formulas[i].number << ": "
                                     << arm.formulas[i].right.written() << ": " << verdict.text();
      }
    }
  }
}

/// The judge itself: verdicts that one can see.
TEST(Errata, VerdictsOfPlainCases) {
  Arm arm{"rr_planar", "", {}, {{"", "theta2", {}, {}, ""}}};
  const Judge judge(arm, *robot_of("rr_planar"));
  const std::string cosine = "(px^2 + py^2 - l1^2 - l2^2)/(2*l1*l2)";
  EXPECT_EQ(judge.formula(0, {{}, "pm*acos(" + cosine + ")"}).text(), "right");
  EXPECT_EQ(judge.formula(0, {{}, "acos(" + cosine + ")"}).text(), "right iff theta2 > 0");
  EXPECT_EQ(judge.formula(0, {{}, "sign(px*py)*acos(" + cosine + ")"}).text().substr(0, 10), "right for ");
  EXPECT_EQ(judge.formula(0, {{}, "2*pm*acos(" + cosine + ")"}).text(), "wrong");
  EXPECT_EQ(judge.formula(0, {{}, "pm*pm2*acos(pm2*" + cosine + ")"}).text(),
            "right with one sign, which it does not tell");
}

TEST(Errata, TheTableIsFresh) {
  std::ifstream file(QVGEN_SOURCE_DIR "/tests/inverse/errata/README.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == table()) << "to update it: qvgen_errata_table > tests/inverse/errata/README.md";
}

}  // namespace
}  // namespace qvgen::test::errata
