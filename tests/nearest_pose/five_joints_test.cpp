// SPDX-License-Identifier: MIT
// Whole poses of an arm with five joints that were rounded or measured: what a tolerance takes, and what the
// nearest pose says.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/five_joints.h>
#include <qvgen/robots/five_joints/nearest_pose.h>

namespace qvgen::test {
namespace {

namespace arm = robots::five_joints;
using Joints = arm::JointVector<double>;

class FiveJoints : public testing::Test {
 protected:
  Joints joints() {
    std::uniform_real_distribution<double> angle(-3, 3);
    Joints q;
    for (double& each : q) each = angle(random_);
    return q;
  }
  /// Every number of the pose off by at most this.
  Pose<double> disturbed(Pose<double> pose, double by) {
    std::uniform_real_distribution<double> noise(-by, by);
    for (double& each : pose.position) each += noise(random_);
    for (double& each : pose.orientation.coeffs()) each += noise(random_);
    return pose.normalised();
  }
  static double apart(const Joints& a, const Joints& b) {
    double most = 0;
    for (int i = 0; i < arm::dof; ++i) most = std::max(most, std::abs(without_turns(a[i] - b[i])));
    return most;
  }

 private:
  std::mt19937 random_{1};
};

TEST_F(FiveJoints, AToleranceTakesWhatIsOffByLess) {
  for (const double off : {1e-13, 1e-10, 1e-8, 1e-6, 1e-5})
    for (int i = 0; i < 300; ++i) {
      const Joints q = joints();
      const Pose<double> pose = disturbed(arm::forward_kinematics(q), off);
      // A share of the arm's size, which is less than a metre.
      const double tolerance = 20 * off;
      const auto found = arm::inverse_kinematics(pose, arm::Geometry{}, tolerance);
      ASSERT_FALSE(found.empty()) << off << ": " << q.transpose();
      for (const auto& row : found) {
        const Pose<double> reached = arm::forward_kinematics(row.q);
        EXPECT_LT(linear_distance(reached, pose), tolerance);
        EXPECT_LT(angular_distance(reached, pose), 2 * tolerance);
      }
    }
}

TEST_F(FiveJoints, ByDefaultWhatIsOffIsUnreachable) {
  int unreachable = 0;
  for (int i = 0; i < 100; ++i) {
    const auto found = arm::inverse_kinematics(disturbed(arm::forward_kinematics(joints()), 1e-6));
    unreachable += found.status == Status::unreachable ? 1 : 0;
  }
  EXPECT_GE(unreachable, 99);
}

/// No farther off than the joints that the pose was made from, and both rows of an elbow that is up or down.
TEST_F(FiveJoints, TheNearestPoseOfARoundedOne) {
  int unreachable = 0;
  for (int i = 0; i < 100; ++i) {
    const Joints q = joints();
    const Pose<double> exact = arm::forward_kinematics(q);
    const Pose<double> pose = exact.cast<float>().cast<double>();
    const auto rows = arm::nearest_pose(pose);
    ASSERT_FALSE(rows.empty());
    unreachable += rows.status == Status::unreachable ? 1 : 0;
    const double length = 1;  // m a radian, more than the arm's size
    const double of_sampled = linear_distance(exact, pose) + length * angular_distance(exact, pose);
    EXPECT_LE(rows[0].position_error, of_sampled);
    EXPECT_LE(rows[0].orientation_error, of_sampled / 0.2);
    EXPECT_GE(rows.size(), 2);
    EXPECT_LT(rows[1].position_error + rows[1].orientation_error, 1e-5);
  }
  // The rounding of some poses lies along what the arm can do, but for 1e-11.
  EXPECT_GE(unreachable, 90);
}

/// Rows of the closed form as starts, and no others.
TEST_F(FiveJoints, FromTheRowsOfTheClosedForm) {
  NearestPoseOptions<arm::dof> options;
  options.starts = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose<double> pose = disturbed(arm::forward_kinematics(joints()), 1e-7);
    const auto known = arm::inverse_kinematics(pose, arm::Geometry{}, 1e-5);
    const auto rows = arm::nearest_pose(pose, options, known);
    ASSERT_FALSE(known.empty());
    // Two rows next to a stretched elbow may lead to one minimum between them.
    const double close = 1e-3;
    for (const auto& solution : known)
      EXPECT_TRUE(std::any_of(rows.begin(), rows.end(),
                              [&](const auto& row) { return apart(row.q, solution.q) < close; }));
    for (const auto& row : rows)
      EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                              [&](const auto& solution) { return apart(row.q, solution.q) < close; }));
  }
}

}  // namespace
}  // namespace qvgen::test
