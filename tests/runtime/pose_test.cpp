// SPDX-License-Identifier: MIT
#include <qvgen/pose.h>

#include <gtest/gtest.h>

namespace {

TEST(Pose, IdentityIsNeutral) {
  const qvgen::Pose<double> pose{Eigen::Quaterniond(0.6, 0.8, 0, 0), {1, 2, 3}};
  const auto product = pose * qvgen::Pose<double>::identity();
  EXPECT_EQ(product.position, pose.position);
}

}  // namespace
