// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "known_gaps.h"
#include "reference/load.h"
#include "robot_under_test.h"

namespace qvgen::test {

inline constexpr double pi = 3.14159265358979323846;

/// Poses of a set: a quick run by default; QVGEN_POSES=100000 for the full size.
inline int pose_count() {
  const char* text = std::getenv("QVGEN_POSES");
  return text == nullptr ? 1000 : std::atoi(text);
}

/// One robot with its reference chain: samples joints, knows whether rows are right.
class Case {
 public:
  explicit Case(const InverseUnderTest& robot)
      : robot_(robot), chain_(reference::load(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot.robot + ".toml")) {}

  [[nodiscard]] const InverseUnderTest& robot() const { return robot_; }
  [[nodiscard]] const reference::Chain& chain() const { return chain_; }
  [[nodiscard]] bool revolute(int joint) const { return chain_.joints[static_cast<std::size_t>(joint)].revolute; }

  Eigen::VectorXd joints() {
    std::uniform_real_distribution<double> turn(-pi, pi);
    return Eigen::VectorXd::NullaryExpr(robot_.dof, [&] { return turn(random_); });
  }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  [[nodiscard]] Eigen::Isometry3d tool(const Eigen::VectorXd& q) const { return reference::forward_kinematics(chain_, q); }
  [[nodiscard]] double given(const Eigen::VectorXd& q) const { return robot_.info.given_joint < 0 ? 0 : q[robot_.info.given_joint]; }
  [[nodiscard]] Found solve(const Eigen::VectorXd& q) const { return robot_.solve(Pose<double>::from_isometry(tool(q)), given(q), 1e-12); }

  /// Largest of the position's (m) and the orientation's (rad) difference, as far as the robot's solver uses it.
  [[nodiscard]] double miss(const Eigen::VectorXd& q, const Eigen::Isometry3d& target) const {
    const Eigen::Isometry3d reached = tool(q);
    const double position = (reached.translation() - target.translation()).norm();
    if (!robot_.info.uses_orientation) return position;
    return std::max(position, (reached.linear() - target.linear()).norm());
  }

  /// Largest difference of two joint vectors, revolute joints the short way round.
  [[nodiscard]] double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return difference(a, b).cwiseAbs().maxCoeff();
  }
  [[nodiscard]] Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    Eigen::VectorXd result = b - a;
    for (int i = 0; i < robot_.dof; ++i)
      if (revolute(i)) result[i] = std::remainder(result[i], 2 * pi);
    return result;
  }

  /// Whether the joints stand in the set: as a row, or joined to one by a line all of whose points reach the pose,
  /// or on a marked continuum.
  [[nodiscard]] bool contains(const Found& found, const Eigen::VectorXd& q) const {
    const Eigen::Isometry3d target = tool(q);
    for (const Row& row : found.rows) {
      const Eigen::VectorXd way = difference(q, row.q);
      if (way.cwiseAbs().maxCoeff() < 1e-6 || row.continuum) return true;
      if (miss(q + 0.5 * way, target) < 1e-12 && miss(q + 0.25 * way, target) < 1e-12) return true;
    }
    return false;
  }

  /// What must hold for every set: rows reach the pose, lie in range, are in order and none is there twice.
  void expect_clean(const Found& found, const Eigen::Isometry3d& target) const {
    // 1e-12 is the demand; joint values of prismatic arms and reaches of some metres come on top as a factor.
    const double size = 1 + target.translation().norm();
    ASSERT_LE(static_cast<int>(found.rows.size()), robot_.info.capacity);
    EXPECT_EQ(found.rows.empty(), found.status == Status::unreachable || found.status == Status::invalid);
    bool continuum = false;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
      const Row& row = found.rows[i];
      continuum = continuum || row.continuum;
      EXPECT_LT(miss(row.q, target), 1e-12 * size) << robot_.name << " row " << i << ": " << row.q.transpose();
      for (int k = 0; k < robot_.dof; ++k)
        if (revolute(k) && k != robot_.info.given_joint) {
          EXPECT_TRUE(row.q[k] > -pi && row.q[k] <= pi) << row.q[k];
        }
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_LT(found.rows[j].branch, row.branch);
        EXPECT_GT(distance(found.rows[j].q, row.q), 1e-9) << robot_.name << " rows " << j << " and " << i;
      }
    }
    if (!found.rows.empty()) {
      EXPECT_EQ(found.status, continuum ? Status::singular : Status::solved);
    }
  }

 private:
  const InverseUnderTest& robot_;
  reference::Chain chain_;
  std::mt19937_64 random_{20070711};
};

class Inverse : public testing::TestWithParam<InverseUnderTest> {
 protected:
  void SetUp() override {
    if (is_known_gap(testing::UnitTest::GetInstance()->current_test_info()->name())) GTEST_SKIP() << "known gap";
    test_ = std::make_unique<Case>(GetParam());
  }
  Case& test() { return *test_; }

  /// Poses of joints that `shape` has brought into a special place.
  template <class Shape>
  void run(Shape&& shape) {
    for (int i = 0; i < pose_count() && !HasFailure(); ++i) {
      Eigen::VectorXd q = test().joints();
      shape(q);
      const Found found = test().solve(q);
      test().expect_clean(found, test().tool(q));
      EXPECT_TRUE(test().contains(found, q)) << GetParam().name << " misses " << q.transpose();
    }
  }

 private:
  std::unique_ptr<Case> test_;
};

}  // namespace qvgen::test
