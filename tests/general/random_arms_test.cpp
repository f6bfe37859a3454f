// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <gtest/gtest.h>

#include "arms.h"

namespace qvgen::test {
namespace {

int arm_count() {
  const char* text = std::getenv("QVGEN_ARMS");
  return text == nullptr ? 25 : std::atoi(text);
}

/// Arms with all lengths and twists drawn at random: the joints from which poses are made are among the rows.
void check_arms(int slides) {
  constexpr int poses = 50;
  int missing = 0, incomplete = 0;
  for (int number = 0; number < arm_count(); ++number) {
    const Arm arm = random_arm(1000 + static_cast<unsigned>(number), slides);
    const auto setup = inverse::general::set_up(arm.description());
    ASSERT_GT(setup.count, 0) << arm.name;
    Random random(static_cast<unsigned>(number));
    for (int i = 0; i < poses; ++i) {
      const Joints6 q = arm.joints(random);
      const Eigen::Isometry3d target = arm.tool(q);
      const auto found = solve(setup, Pose<double>::from_isometry(target), instruction_sets[i % 3]);
      EXPECT_EQ(fault(arm, target, found), "");
      const bool told = found.status == Status::incomplete;
      incomplete += told ? 1 : 0;
      missing += contains(arm, found, q) || told ? 0 : 1;
    }
  }
  EXPECT_EQ(missing, 0);
  EXPECT_LE(incomplete, arm_count() * poses / 100);
}

TEST(RandomArms, SixRevoluteJoints) { check_arms(0); }
TEST(RandomArms, OneSlideAnywhere) { check_arms(1); }

TEST(RandomArms, TwoSlidesAnywhere) { check_arms(2); }

/// Three slides have a closed form: that they are not solved here is said at once, not found out pose by
/// pose.
TEST(RandomArms, ThreeSlidesAreRefused) {
  for (unsigned number = 0; number < 5; ++number)
    EXPECT_EQ(inverse::general::set_up(random_arm(number, 3).description()).count, 0);
}

}  // namespace
}  // namespace qvgen::test
