// SPDX-License-Identifier: MIT
#include "derive/kinematics/zero_reference.h"

#include <gtest/gtest.h>

#include "description/reader.h"

namespace {

using namespace qvgen;

std::optional<derive::ZeroReferenceChain> chain_of(const char* robot) {
  const auto read =
      description::read_file(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot + ".toml");
  return derive::zero_reference_chain(*read.robot);
}

bool along(const symbolic::Vector& axis, int x, int y, int z) {
  return axis.x.is_equal(x) && axis.y.is_equal(y) && axis.z.is_equal(z);
}

TEST(ZeroReference, RightAngledTableGivesCoordinateAxes) {
  const auto chain = chain_of("puma560");
  ASSERT_TRUE(chain);
  ASSERT_EQ(chain->joints.size(), 6U);
  EXPECT_TRUE(along(chain->joints[0].axis, 0, 0, 1));
  EXPECT_TRUE(along(chain->joints[1].axis, 0, -1, 0));
  EXPECT_TRUE(along(chain->joints[2].axis, 0, -1, 0));
  EXPECT_TRUE(along(chain->joints[3].axis, 0, 0, 1));
  EXPECT_TRUE(along(chain->joints[4].axis, 0, -1, 0));
  EXPECT_TRUE(along(chain->joints[5].axis, 0, 0, 1));
  EXPECT_TRUE(chain->home.w.is_equal(1));
}

TEST(ZeroReference, SymbolicTwistsAreLeftToLocalFrames) { EXPECT_FALSE(chain_of("general_6r")); }

}  // namespace
