// SPDX-License-Identifier: MIT
#include "reference/chain.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "reference/load.h"

namespace {

using namespace reference;

std::vector<Chain> all_robots() {
  std::vector<Chain> chains;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() != ".toml") continue;
    // Symbols without a default get one that no robot has otherwise.
    Values values;
    const char letters[] = {'l', 'd', 'h', 'a'};
    for (const char letter : letters) {
      for (int i = 1; i <= 6; ++i) values[letter + std::to_string(i)] = 0.1 * i + 0.01 * letter;
    }
    chains.push_back(load(entry.path(), values));
  }
  return chains;
}

TEST(Chain, PlanarArmByHand) {
  Chain arm;
  arm.joints.resize(2);
  arm.joints[0].after.translation().x() = 0.4;
  arm.joints[1].after.translation().x() = 0.3;
  const double a = 0.7;
  const double b = -1.1;
  const Isometry3d tool = forward_kinematics(arm, Eigen::Vector2d(a, b));
  EXPECT_NEAR(tool.translation().x(), 0.4 * std::cos(a) + 0.3 * std::cos(a + b), 1e-15);
  EXPECT_NEAR(tool.translation().y(), 0.4 * std::sin(a) + 0.3 * std::sin(a + b), 1e-15);
}

TEST(Chain, JacobianIsTheDerivative) {
  const double step = 1e-5;
  for (const Chain& chain : all_robots()) {
    const VectorXd q = VectorXd::LinSpaced(chain.size(), 0.3, 2.1);
    const MatrixXd exact = jacobian(chain, q);
    const Matrix3d rotation = forward_kinematics(chain, q).linear();
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const VectorXd h = step * VectorXd::Unit(chain.size(), i);
      const Isometry3d plus = forward_kinematics(chain, q + h);
      const Isometry3d minus = forward_kinematics(chain, q - h);
      const Vector3d linear = (plus.translation() - minus.translation()) / (2 * step);
      const Matrix3d spin = (plus.linear() - minus.linear()) / (2 * step) * rotation.transpose();
      EXPECT_LT((linear - exact.block<3, 1>(0, i)).norm(), 1e-8) << chain.name;
      EXPECT_LT((Vector3d(spin(2, 1), spin(0, 2), spin(1, 0)) - exact.block<3, 1>(3, i)).norm(), 1e-8)
          << chain.name;
    }
  }
}

}  // namespace
