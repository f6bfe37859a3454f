// SPDX-License-Identifier: MIT
// The functions in C against those in C++: other sines and another order of operations, the same numbers.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/coupled/frames.h>
#include <qvgen/robots/coupled/geometry_jacobian.h>
#include <qvgen/robots/coupled/mass.h>
#include <qvgen/robots/coupled/regressor_with_drives.h>

#include "qvgen_coupled.h"

namespace {

namespace arm = qvgen::robots::coupled;
using Joints = arm::JointVector<double>;

template <int Rows, int Columns>
using RowMajor = Eigen::Matrix<double, Rows, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

template <int Rows, int Columns>
auto matrix(const double (&entries)[Rows][Columns]) {
  return RowMajor<Rows, Columns>(&entries[0][0]);
}

class FramesInC : public testing::Test {
 protected:
  Joints random() {
    return Joints::NullaryExpr([&] { return std::uniform_real_distribution(-3.0, 3.0)(random_); });
  }
  template <class A, class B>
  void expect_near(const A& a, const B& b) {
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-12 * (1 + b.cwiseAbs().maxCoeff()));
  }

 private:
  std::mt19937 random_{11};
};

TEST_F(FramesInC, PosesAndJacobians) {
  const coupled_geometry geometry{};
  for (int k = 0; k < 100; ++k) {
    const Joints q = random();
    double jacobian[6][arm::dof], poses[arm::frame_count][4][4];
    coupled_jacobian_of_palm(q.data(), &geometry, jacobian);
    expect_near(matrix(jacobian), arm::jacobian_of(arm::Frame::palm, q));
    coupled_frame_poses(q.data(), &geometry, poses);
    const auto expected = arm::frame_poses(q);
    for (std::size_t i = 0; i < expected.size(); ++i) expect_near(matrix(poses[i]), expected[i].matrix());
    coupled_pose pose;
    coupled_forward_kinematics_of_tip(q.data(), &geometry, &pose);
    const auto tip = arm::forward_kinematics_of(arm::Frame::tip, q);
    EXPECT_NEAR(pose.orientation[2], tip.orientation.y(), 1e-12);
    EXPECT_NEAR(pose.position[2], tip.position[2], 1e-12);
    EXPECT_EQ(static_cast<int>(coupled_frame_tip), static_cast<int>(arm::Frame::tip));
  }
}

TEST_F(FramesInC, ErrorsOfTheGeometry) {
  const coupled_geometry geometry{};
  for (int k = 0; k < 100; ++k) {
    const Joints q = random();
    double columns[6][arm::geometry_error_count];
    coupled_geometry_jacobian(q.data(), &geometry, columns);
    expect_near(matrix(columns), arm::geometry_jacobian(q));
  }
}

TEST_F(FramesInC, MassesAndRegressors) {
  const coupled_geometry geometry{};
  arm::Inertia inertia{};
  coupled_inertia in_c{};
  inertia.m1 = in_c.m1 = 2;
  inertia.m3 = in_c.m3 = 3;
  inertia.c3x = in_c.c3x = 0.1;
  EXPECT_EQ(coupled_total_mass(&geometry, &in_c), 5);
  for (int k = 0; k < 100; ++k) {
    const Joints q = random(), qd = random(), qdd = random();
    double centre[3], moves[3][arm::dof], y[arm::dof][coupled_identifiable_parameter_count];
    coupled_centre_of_mass(q.data(), &geometry, &in_c, centre);
    expect_near(Eigen::Map<Eigen::Vector3d>(centre), arm::centre_of_mass<double>(q, {}, inertia));
    coupled_centre_of_mass_jacobian(q.data(), &geometry, &in_c, moves);
    expect_near(matrix(moves), arm::centre_of_mass_jacobian<double>(q, {}, inertia));
    coupled_regressor_with_drives(q.data(), qd.data(), qdd.data(), &geometry, &in_c, 9.5, y);
    expect_near(matrix(y), arm::regressor_with_drives<double>(q, qd, qdd, {}, {}, 9.5));
  }
}

}  // namespace
