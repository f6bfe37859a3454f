// SPDX-License-Identifier: MIT
// Generated frames, masses and regressors with drives against the reference in numbers, at random
// configurations.
#include <random>

#include <gtest/gtest.h>

#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"
#include "robot_under_test.h"

namespace qvgen::test {
namespace {

constexpr int configurations = 200;
constexpr double gravity = 9.5;
/// Some hundred operations on values of the size of metres and newtons.
constexpr double tolerance = 1e-12;

class Robots : public testing::TestWithParam<RobotUnderTest> {
 protected:
  Robots() {
    reference::Values values;
    inertia_.resize(static_cast<Eigen::Index>(robot().inertia_names.size()));
    Eigen::Index place = 0;
    for (const std::string& name : robot().inertia_names) {
      inertia_[place] = name[0] == 'm' ? 2 + uniform(1) : uniform(0.3);
      values[name] = inertia_[place++];
    }
    chain_ = reference::load(robot().description, values);
  }

  static const RobotUnderTest& robot() { return GetParam(); }
  double uniform(double size) { return std::uniform_real_distribution(-size, size)(random_); }
  VectorXd vector(Eigen::Index count, double size) {
    return VectorXd::NullaryExpr(count, [&] { return uniform(size); });
  }
  VectorXd configuration() { return vector(chain_.size(), 3); }

  /// Every frame as the reference has it, links first.
  [[nodiscard]] std::vector<reference::NamedFrame> frames() const {
    std::vector<reference::NamedFrame> all;
    for (std::size_t i = 0; i < chain_.joints.size(); ++i)
      all.push_back({"link" + std::to_string(i + 1), i, Isometry3d::Identity()});
    all.insert(all.end(), chain_.frames.begin(), chain_.frames.end());
    return all;
  }

  VectorXd inertia_;
  reference::Chain chain_;

 private:
  std::mt19937 random_{7};
};

void expect_near(const MatrixXd& found, const MatrixXd& expected, double bound) {
  ASSERT_EQ(found.rows(), expected.rows());
  ASSERT_EQ(found.cols(), expected.cols());
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), bound * (1 + expected.cwiseAbs().maxCoeff()));
}

/// The reference's chain with one frame moved by a little: joint i's before it moves, or the tool's.
reference::Chain moved(reference::Chain chain, std::size_t column, double by) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(column % 3));
  const Isometry3d error =
      column % 6 < 3 ? Isometry3d(Eigen::Translation3d(by * axis)) : Isometry3d(Eigen::AngleAxisd(by, axis));
  const std::size_t frame = column / 6;
  Isometry3d& place = frame < chain.joints.size() ? chain.joints[frame].before : chain.tool;
  place = place * error;
  return chain;
}

TEST_P(Robots, ErrorsOfFramesMoveTheToolAsDifferencesSay) {
  constexpr double step = 1e-5;
  for (int k = 0; k < 20; ++k) {
    const VectorXd q = configuration();
    const MatrixXd found = robot().geometry_jacobian(q);
    ASSERT_EQ(found.cols(), 6 * static_cast<Eigen::Index>(chain_.joints.size() + 1));
    const Isometry3d tool = reference::forward_kinematics(chain_, q);
    for (Eigen::Index column = 0; column < found.cols(); ++column) {
      const auto place = static_cast<std::size_t>(column);
      const Isometry3d more = reference::forward_kinematics(moved(chain_, place, step), q),
                       less = reference::forward_kinematics(moved(chain_, place, -step), q);
      Eigen::Matrix<double, 6, 1> expected;
      const Eigen::Matrix3d spin = (more.linear() - less.linear()) / (2 * step) * tool.linear().transpose();
      expected << (more.translation() - less.translation()) / (2 * step), spin(2, 1), spin(0, 2), spin(1, 0);
      expect_near(found.col(column), expected, 1e-9);
    }
    expect_near(robot().float_geometry_jacobian(q), found, 1e-5);
  }
}

TEST_P(Robots, HaveFramesOfLinksAndThoseThatAreNamed) {
  std::vector<std::string> names;
  for (const reference::NamedFrame& frame : frames()) names.push_back(frame.name);
  EXPECT_EQ(robot().frame_names, names);
}

TEST_P(Robots, PosesOfFramesAreTheReferences) {
  const auto all = frames();
  for (int k = 0; k < configurations; ++k) {
    const VectorXd q = configuration();
    const auto links = robot().link_poses(q), poses = robot().frame_poses(q);
    ASSERT_EQ(links.size(), chain_.joints.size());
    ASSERT_EQ(poses.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const MatrixXd expected = reference::pose_of(chain_, all[i], q).matrix();
      expect_near(poses[i].matrix(), expected, tolerance);
      if (i < links.size()) expect_near(links[i].matrix(), expected, tolerance);
      expect_near(robot().pose_of(i, q).matrix(), expected, tolerance);
      expect_near(robot().transform_of(i, q).matrix(), expected, tolerance);
      expect_near(robot().float_pose_of(i, q).matrix(), expected, 1e-5);
    }
  }
}

TEST_P(Robots, JacobiansOfFramesAreTheReferences) {
  const auto all = frames();
  for (int k = 0; k < configurations; ++k) {
    const VectorXd q = configuration();
    for (std::size_t i = 0; i < all.size(); ++i)
      expect_near(robot().jacobian_of(i, q), reference::jacobian_of(chain_, all[i], q), tolerance);
  }
}

TEST_P(Robots, CentreOfMassIsTheReferences) {
  EXPECT_NEAR(robot().total_mass(inertia_), reference::total_mass(chain_), tolerance);
  for (int k = 0; k < configurations; ++k) {
    const VectorXd q = configuration();
    const Vector3d expected = reference::centre_of_mass(chain_, q);
    expect_near(robot().centre_of_mass(inertia_, q), expected, tolerance);
    expect_near(robot().float_centre_of_mass(inertia_, q), expected, 1e-5);
    expect_near(robot().centre_of_mass_jacobian(inertia_, q), reference::centre_of_mass_jacobian(chain_, q),
                tolerance);
  }
}

/// Ten of each link: mass, first moments, inertia about the origin.
VectorXd standard_parameters(const reference::Chain& chain) {
  VectorXd result(10 * static_cast<Eigen::Index>(chain.joints.size()));
  Eigen::Index place = 0;
  for (const reference::Joint& joint : chain.joints) {
    const Vector3d& c = joint.centre_of_mass;
    const Eigen::Matrix3d about_origin =
        joint.inertia + joint.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    result.segment<10>(place) << joint.mass, joint.mass * c, about_origin.diagonal(), about_origin(0, 1),
        about_origin(1, 2), about_origin(0, 2);
    place += 10;
  }
  return result;
}

TEST_P(Robots, RegressorWithDrivesGivesTheReferencesForces) {
  const auto joints = static_cast<Eigen::Index>(chain_.joints.size());
  const VectorXd drives = vector(4 * joints, 2), standard = standard_parameters(chain_);
  VectorXd offsets(joints);
  for (Eigen::Index i = 0; i < joints; ++i) {
    reference::Joint& joint = chain_.joints[static_cast<std::size_t>(i)];
    joint.rotor_inertia = drives[4 * i];
    joint.viscous_friction = drives[4 * i + 1];
    joint.coulomb_friction = drives[4 * i + 2];
    offsets[i] = drives[4 * i + 3];
  }
  const VectorXd parameters = robot().parameters(standard, drives, gravity);
  for (int k = 0; k < configurations; ++k) {
    const VectorXd q = configuration(), qd = configuration(), qdd = configuration();
    const VectorXd expected = reference::inverse_dynamics(chain_, q, qd, qdd, {0, 0, gravity}) +
                              chain_.coupling().transpose() * offsets;
    expect_near(robot().regressor(q, qd, qdd, gravity) * parameters, expected, 10 * tolerance);
  }
}

/// Over many motions no column follows from the others, so that all parameters can be identified.
TEST_P(Robots, RegressorWithDrivesHasIndependentColumns) {
  const Eigen::Index rows = chain_.size(), motions = 60;
  const auto columns = static_cast<Eigen::Index>(robot().identifiable_names.size());
  MatrixXd all(rows * motions, columns);
  for (Eigen::Index k = 0; k < motions; ++k)
    all.middleRows(k * rows, rows) =
        robot().regressor(configuration(), configuration(), configuration(), gravity);
  all.colwise().normalize();
  EXPECT_EQ(reference::rank(all, 1e-9), columns);
}

INSTANTIATE_TEST_SUITE_P(Generated, Robots, testing::ValuesIn(robots_under_test()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
}  // namespace qvgen::test
