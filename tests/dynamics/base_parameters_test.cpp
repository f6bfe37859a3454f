// SPDX-License-Identifier: MIT
// How many inertial parameters can be told apart: published 36 for PUMA 560 and RX-90, 33 for the Stanford
// arm.
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <qvgen/robots/general_6r/regressor.h>
#include <qvgen/robots/puma560/regressor.h>
#include <qvgen/robots/rx90/regressor.h>
#include <qvgen/robots/stanford/regressor.h>

namespace {

namespace robots = qvgen::robots;

TEST(BaseParameters, AreAsManyAsPublished) {
  EXPECT_EQ(robots::puma560::base_parameter_count, 36);
  EXPECT_EQ(robots::rx90::base_parameter_count, 36);
  EXPECT_EQ(robots::stanford::base_parameter_count, 33);
  EXPECT_EQ(robots::general_6r::base_parameter_count, 36);
}

TEST(BaseParameters, HaveDifferentNames) {
  const auto& names = robots::puma560::base_parameter_names;
  EXPECT_EQ((std::set<std::string>(names.begin(), names.end()).size()), names.size());
}

/// The map from standard parameters is linear.
TEST(BaseParameters, AreLinearInStandardParameters) {
  using Standard = robots::stanford::StandardParameters<double>;
  const Standard a = Standard::Random(), b = Standard::Random();
  const auto of = [](const Standard& x) { return robots::stanford::base_parameters(x); };
  EXPECT_LE((of(a + 2 * b) - of(a) - 2 * of(b)).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
