// SPDX-License-Identifier: MIT
// Compiled inverse kinematics of every robot on sets of poses, against an independent chain of homogeneous matrices.
#include "check.h"

namespace qvgen::test {
namespace {

TEST_P(Inverse, FindsTheSampledJoints) {
  run([](Eigen::VectorXd&) {});
}

TEST_P(Inverse, OnALatticeOf45Degrees) {
  run([&](Eigen::VectorXd& q) {
    for (int k = 0; k < q.size(); ++k) q[k] = pi / 4 * std::round(q[k] / (pi / 4));
  });
}

TEST_P(Inverse, EveryJointAtZeroInTurn) {
  int joint = 0;
  run([&](Eigen::VectorXd& q) { q[joint++ % q.size()] = 0; });
}

TEST_P(Inverse, EveryJointNearZeroInTurn) {
  int joint = 0;
  run([&](Eigen::VectorXd& q) {
    const double size = std::pow(10, -test().uniform(1, 12));
    q[joint++ % q.size()] = test().uniform(-1, 1) < 0 ? -size : size;
  });
}

TEST_P(Inverse, EveryJointAtPiInTurn) {
  int joint = 0;
  run([&](Eigen::VectorXd& q) { q[joint++ % q.size()] = pi; });
}

TEST_P(Inverse, PosesRoundedToFloat) {
  int lost = 0;
  for (int i = 0; i < pose_count() && !HasFailure(); ++i) {
    const Eigen::VectorXd q = test().joints();
    Pose<double> pose = Pose<double>::from_isometry(test().tool(q)).cast<float>().cast<double>();
    const Found found = GetParam().solve(pose, test().given(q), 1e-12);
    const Pose<double> target = pose.normalised();
    test().expect_clean(found, target.isometry());
    lost += found.rows.empty() ? 1 : 0;
  }
  // A rounded pose of a planar arm leaves its plane; others are lost only within 1e-7 of the boundary of reach.
  const bool planar = GetParam().info.uses_orientation && GetParam().dof < 6;
  if (!planar) {
    EXPECT_LE(lost, pose_count() / 200) << GetParam().name;
  }
}

TEST_P(Inverse, FarAwayIsUnreachableOrReached) {
  for (int i = 0; i < pose_count(); ++i) {
    const Eigen::VectorXd q = test().joints();
    Eigen::Isometry3d target = test().tool(q);
    target.translation() *= 1000;
    const Found found = GetParam().solve(Pose<double>::from_isometry(target), test().given(q), 1e-12);
    test().expect_clean(found, target);
  }
}

/// Moves a pose outwards until it is lost; there the boundary is found by bisection and both sides are looked at.
TEST_P(Inverse, BoundaryOfReach) {
  for (int i = 0; i < pose_count() / 20; ++i) {
    const Eigen::VectorXd q = test().joints();
    const Eigen::Isometry3d start = test().tool(q);
    const auto at = [&](double s) {
      Eigen::Isometry3d target = start;
      target.translation() *= 1 + s;
      return target;
    };
    const auto solve = [&](double s) { return GetParam().solve(Pose<double>::from_isometry(at(s)), test().given(q), 1e-12); };
    double inside = 0;
    double outside = 100;
    if (!solve(outside).rows.empty() || solve(inside).rows.empty()) continue;
    while (outside - inside > 1e-14 * (1 + inside)) {
      const double middle = (inside + outside) / 2;
      (solve(middle).rows.empty() ? outside : inside) = middle;
    }
    test().expect_clean(solve(inside), at(inside));
    test().expect_clean(solve(inside - 1e-13), at(inside - 1e-13));
    EXPECT_EQ(solve(outside + 1e-9).status, Status::unreachable);
  }
}

TEST_P(Inverse, InvalidInputIsSaid) {
  const Eigen::VectorXd q = test().joints();
  const Pose<double> good = Pose<double>::from_isometry(test().tool(q));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (int k = 0; k < 4; ++k) {
      Pose<double> pose = good;
      pose.orientation.coeffs()[k] = bad;
      EXPECT_EQ(GetParam().solve(pose, test().given(q), 1e-12).status, Status::invalid);
    }
    for (int k = 0; k < 3; ++k) {
      Pose<double> pose = good;
      pose.position[k] = bad;
      EXPECT_EQ(GetParam().solve(pose, test().given(q), 1e-12).status, Status::invalid);
    }
  }
  for (const double length : {0.0, 0.5, 2.0}) {
    Pose<double> pose = good;
    pose.orientation.coeffs() *= length;
    EXPECT_EQ(GetParam().solve(pose, test().given(q), 1e-12).status, Status::invalid);
  }
  Eigen::Matrix3d reflection = test().tool(q).linear();
  reflection.col(0) *= -1;
  EXPECT_EQ(GetParam().solve_matrix(reflection, good.position, test().given(q)).status, Status::invalid);
  EXPECT_EQ(GetParam().solve_matrix(2 * test().tool(q).linear(), good.position, test().given(q)).status, Status::invalid);
}

TEST_P(Inverse, OppositeQuaternionAndMatrixGiveTheSame) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = test().joints();
    const Eigen::Isometry3d target = test().tool(q);
    Pose<double> pose = Pose<double>::from_isometry(target);
    const Found a = GetParam().solve(pose, test().given(q), 1e-12);
    pose.orientation.coeffs() *= -1;
    const Found b = GetParam().solve(pose, test().given(q), 1e-12);
    const Found c = GetParam().solve_matrix(target.linear(), target.translation(), test().given(q));
    ASSERT_EQ(a.rows.size(), b.rows.size());
    ASSERT_EQ(a.rows.size(), c.rows.size());
    for (std::size_t k = 0; k < a.rows.size(); ++k) {
      EXPECT_EQ(a.rows[k].branch, b.rows[k].branch);
      EXPECT_LT(test().distance(a.rows[k].q, b.rows[k].q), 1e-9);
      EXPECT_LT(test().distance(a.rows[k].q, c.rows[k].q), 1e-9);
    }
  }
}

std::string name_of(const testing::TestParamInfo<InverseUnderTest>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Robots, Inverse, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
