// SPDX-License-Identifier: MIT
#include "report/branch_signs.h"

#include <gtest/gtest.h>

#include "description/reader.h"
#include "pipeline/products/inverse_derivation.h"

namespace {

using namespace qvgen;

class OfKnownRobots : public testing::TestWithParam<const char*> {};

TEST_P(OfKnownRobots, DigitsNumberEveryBranchOnce) {
  const std::string file = std::string(QVGEN_SOURCE_DIR "/generator/robots/") + GetParam() + ".toml";
  const auto robot = description::read_file(file, {}).robot;
  ASSERT_TRUE(robot);
  for (const auto& form : pipeline::derive_inverse(*robot).closed_forms) {
    int branches = 1;
    for (const report::BranchSign& sign : report::branch_signs(form.plan)) {
      EXPECT_FALSE(sign.name.empty());
      EXPECT_FALSE(sign.meet.empty());
      branches *= sign.values;
    }
    EXPECT_EQ(branches, form.plan.capacity);
  }
}

// Two signs and a wrist, parallel axes, a quartic, slides, two joints, a turn that is given.
INSTANTIATE_TEST_SUITE_P(BranchSigns, OfKnownRobots,
                         testing::Values("puma560", "ur5", "rn", "stanford", "pan_tilt", "iiwa14"));

}  // namespace
