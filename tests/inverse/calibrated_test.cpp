// SPDX-License-Identifier: MIT
// Calibrated arms from the closed forms of the ideal ones.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/calibrated.h>
#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/ur5.h>
#include <qvgen/robots/ur5_measured.h>

#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using Joints = Eigen::Matrix<double, 6, 1>;

struct Ideal {
  const char* name;
  Solutions<6, 1> (*near)(const Pose<double>&, const Joints&);
  Pose<double> (*forward)(const Joints&);
};

#define IDEAL(NAME)                                                                                                      \
  Ideal {                                                                                                                \
#NAME, [](const Pose<double>& pose, const Joints& seed) { return robots::NAME::inverse_kinematics_near(pose, seed); }, \
        [](const Joints& q) { return robots::NAME::forward_kinematics(q); } \
  }
const Ideal ideals[] = {IDEAL(ur5), IDEAL(irb6640), IDEAL(puma560)};

/// Every axis turned and moved by about as much as this, rad and m.
class Arm {
 public:
  Arm(const Ideal& ideal, double by, unsigned seed) : ideal_(ideal), random_(seed) {
    chain_ = reference::load(std::string(QVGEN_SOURCE_DIR "/generator/robots/") + ideal.name + ".toml");
    for (reference::Joint& joint : chain_.joints) {
      joint.before.translate(vector(by));
      joint.before.rotate(Eigen::AngleAxisd(by, vector(1).normalized()));
    }
  }

  [[nodiscard]] Pose<double> pose(const Joints& q) const {
    return Pose<double>::from_isometry(reference::forward_kinematics(chain_, q));
  }
  [[nodiscard]] Eigen::Matrix<double, 6, 6> jacobian(const Joints& q) const {
    return reference::jacobian(chain_, q);
  }
  [[nodiscard]] Solutions<6, 1> near(const Pose<double>& pose, const Joints& seed) const {
    const inverse::Calibrated arm{ideal_.near, ideal_.forward, [&](const Joints& q) { return this->pose(q); },
                                  [&](const Joints& q) { return jacobian(q); }};
    return arm.near(pose, seed);
  }
  Joints joints(double size) {
    Joints q;
    for (double& x : q) x = uniform(size);
    return q;
  }

 private:
  double uniform(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  Eigen::Vector3d vector(double size) { return {uniform(size), uniform(size), uniform(size)}; }

  Ideal ideal_;
  std::mt19937 random_;
  reference::Chain chain_;
};

double turn_between(const Joints& a, const Joints& b) {
  double largest = 0;
  for (int i = 0; i < 6; ++i)
    largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2 * 3.14159265358979323846)));
  return largest;
}

class CalibratedArm : public testing::TestWithParam<Ideal> {};

/// Along a path's steps, singular poses but for a hundredth left out: the joints that made the pose. A row is
/// never wrong, there neither.
TEST_P(CalibratedArm, FindsTheJointsNextToTheSeed) {
  for (const double by : {1e-4, 1e-3, 1e-2}) {
    Arm arm(GetParam(), by, 1);
    int empty = 0;
    for (int i = 0; i < 1000; ++i) {
      const Joints q = arm.joints(3);
      const Pose<double> pose = arm.pose(q);
      const auto found = arm.near(pose, q + arm.joints(0.001));
      const bool regular = reference::smallest_singular_value(arm.jacobian(q)) > 0.01;
      if (regular) {
        ASSERT_EQ(found.size(), 1) << by << ": " << q.transpose();
        EXPECT_LT(turn_between(found[0].q, q), 1e-9) << by << ": " << q.transpose();
      }
      empty += found.empty() ? 1 : 0;
      if (found.empty()) continue;
      const Pose<double> reached = arm.pose(found[0].q);
      EXPECT_LT((reached.position - pose.position).norm(), 1e-11);
      EXPECT_LT(angular_distance(reached, pose), 1e-11);
    }
    EXPECT_LE(empty, 5) << by;
  }
}

TEST_P(CalibratedArm, SaysWhatItCannotDo) {
  const Arm arm(GetParam(), 1e-3, 2);
  const Joints seed = Joints::Constant(0.3);
  Pose<double> pose = arm.pose(seed);
  pose.position *= 100;
  EXPECT_EQ(arm.near(pose, seed).status, Status::incomplete);
  EXPECT_TRUE(arm.near(pose, seed).empty());
  pose.position[0] = std::nan("");
  EXPECT_EQ(arm.near(pose, seed).status, Status::invalid);
  EXPECT_TRUE(arm.near(pose, seed).empty());
}

/// A quaternion off its length is normalised, as by the ideal arm.
TEST_P(CalibratedArm, TakesAQuaternionOffItsLength) {
  const Arm arm(GetParam(), 1e-3, 3);
  const Joints q(0.3, -0.9, 1.1, 0.4, 0.8, -0.2);
  Pose<double> pose = arm.pose(q);
  pose.orientation.coeffs() *= 1 + 1e-7;
  const auto found = arm.near(pose, q);
  ASSERT_EQ(found.size(), 1);
  EXPECT_LT(turn_between(found[0].q, q), 1e-9);
}

/// The function that a description with `ideal` has.
TEST(CalibratedDescription, HasTheFunction) {
  const reference::Chain chain = reference::load(QVGEN_SOURCE_DIR "/tests/inverse/ur5_measured.toml");
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-3, 3), aside(-1e-3, 1e-3);
  int regular = 0;
  for (int i = 0; i < 200; ++i) {
    Joints q, seed;
    for (int k = 0; k < 6; ++k) seed[k] = (q[k] = angle(random)) + aside(random);
    if (reference::smallest_singular_value(reference::jacobian(chain, q)) < 0.01) continue;
    const auto pose = Pose<double>::from_isometry(reference::forward_kinematics(chain, q));
    const auto found = robots::ur5_measured::inverse_kinematics_from_ideal(pose, seed);
    ASSERT_EQ(found.size(), 1) << q.transpose();
    EXPECT_LT(turn_between(found[0].q, q), 1e-9) << q.transpose();
    ++regular;
  }
  EXPECT_GT(regular, 100);
}

INSTANTIATE_TEST_SUITE_P(Arms, CalibratedArm, testing::ValuesIn(ideals),
                         [](const auto& ideal) { return std::string(ideal.param.name); });

}  // namespace
}  // namespace qvgen::test
