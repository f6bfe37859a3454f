// SPDX-License-Identifier: MIT
#include "reference/load.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using namespace reference;

constexpr double pi = 3.14159265358979323846;

Isometry3d about_z(double angle) { return Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ())); }
Isometry3d about_x(double angle) { return Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitX())); }
Isometry3d at(double x, double y, double z) { return Isometry3d(Eigen::Translation3d(x, y, z)); }

void expect_same(const Isometry3d& a, const Isometry3d& b) {
  EXPECT_LT((a.matrix() - b.matrix()).norm(), 1e-14);
}

TEST(Load, Joints) {
  const Chain chain = load_text(R"(
    name = "a"
    [defaults]
    h = "1/2"
    [base]
    translation = [0, 0, 1]
    turns = [{ axis = "-x", angle = "90 deg" }]
    [[joint]]
    type = "revolute"
    axis = "-z"
    variable = "t"
    origin = [0, 0, "2*h"]
    rpy = [0.1, 0.2, 0.3]
    link = [3, 0, 0]
    limits = ["-90 deg", 1]
    [[joint]]
    type = "prismatic"
    axis = [0, 0.6, 0.8]
    variable = "d")",
                                {{"h", 7}});
  ASSERT_EQ(chain.size(), 2);
  const Isometry3d rpy = about_z(0.3) * Isometry3d(Eigen::AngleAxisd(0.2, Vector3d::UnitY())) * about_x(0.1);
  expect_same(
      forward_kinematics(chain, Eigen::Vector2d(0.4, 0.5)),
      at(0, 0, 1) * about_x(-pi / 2) * at(0, 0, 14) * rpy * about_z(-0.4) * at(3, 0, 0) * at(0, 0.3, 0.4));
  EXPECT_DOUBLE_EQ(chain.joints[0].lower, -pi / 2);
  EXPECT_EQ(chain.joints[0].upper, 1);
  EXPECT_TRUE(std::isinf(chain.joints[1].upper));
}

TEST(Load, StandardTable) {
  const Chain chain = load_text(R"(
    name = "a"
    convention = "standard"
    [[dh]]
    variable = "t"
    theta = "90 deg - t"
    d = 0.1
    a = 0.2
    alpha = 0.3
    [[dh]]
    variable = "s"
    theta = 0.4
    d = "0.5 + s"
    [[dh]]
    type = "revolute"
    variable = "u"
    [[dh]]
    a = 0.6)");
  ASSERT_EQ(chain.size(), 3);
  EXPECT_FALSE(chain.joints[1].revolute);
  expect_same(forward_kinematics(chain, Vector3d(0.7, 0.8, 0.9)),
              about_z(pi / 2 - 0.7) * at(0.2, 0, 0.1) * about_x(0.3) * about_z(0.4) * at(0, 0, 1.3) *
                  about_z(0.9) * at(0.6, 0, 0));
}

TEST(Load, ModifiedTable) {
  const Chain chain = load_text(R"(
    name = "a"
    convention = "modified"
    [[dh]]
    variable = "t"
    theta = "t + 0.2"
    d = 0.1
    a = 0.2
    alpha = 0.3
    [[dh]]
    variable = "s"
    alpha = -0.5
    d = "s")");
  expect_same(forward_kinematics(chain, Eigen::Vector2d(0.7, 0.8)),
              about_x(0.3) * at(0.2, 0, 0) * about_z(0.9) * at(0, 0, 0.1) * about_x(-0.5) * at(0, 0, 0.8));
}

TEST(Load, Screws) {
  const Chain chain = load_text(R"(
    name = "a"
    [[screw]]
    type = "revolute"
    axis = "+z"
    variable = "t"
    point = [1, 0, 0]
    [[screw]]
    type = "revolute"
    axis = "+x"
    variable = "u"
    point = [1, 2, 0]
    [home]
    translation = [3, 4, 5])");
  const Isometry3d first = at(1, 0, 0) * about_z(0.3) * at(-1, 0, 0);
  const Isometry3d second = at(1, 2, 0) * about_x(0.4) * at(-1, -2, 0);
  expect_same(forward_kinematics(chain, Eigen::Vector2d(0.3, 0.4)), first * second * at(3, 4, 5));
}

TEST(Load, Inertia) {
  const Chain chain = load_text(R"(
    name = "a"
    inertia = "free"
    [[joint]]
    type = "revolute"
    axis = "+z"
    variable = "t"
    mass = 2
    inertia = [1, 2, 3, 4, 5, 6]
    [[joint]]
    type = "revolute"
    axis = "+z"
    variable = "u")",
                                {{"m2", 3}, {"c2y", 4}, {"I2xz", 5}});
  Matrix3d expected;
  expected << 1, 4, 6, 4, 2, 5, 6, 5, 3;
  EXPECT_EQ(chain.joints[0].inertia, expected);
  EXPECT_EQ(chain.joints[0].mass, 2);
  EXPECT_EQ(chain.joints[1].mass, 3);
  EXPECT_EQ(chain.joints[1].centre_of_mass, Vector3d(0, 4, 0));
  EXPECT_EQ(chain.joints[1].inertia(2, 0), 5);
}

TEST(Load, PumaAtZero) {
  const Chain puma = load(QVGEN_SOURCE_DIR "/generator/robots/puma560.toml");
  // All joints zero: upper arm and elbow along x, forearm along z, 0.15005 to the side.
  const Vector3d tool = forward_kinematics(puma, VectorXd::Zero(6)).translation();
  EXPECT_LT((tool - Vector3d(0.4318 + 0.0203, -0.15005, 0.672 + 0.4318)).norm(), 1e-15);
}

TEST(Load, NoJointsOrNoFile) {
  EXPECT_THROW(load_text("name = 'a'"), std::runtime_error);
  EXPECT_THROW(load("does_not_exist.toml"), std::exception);
}

}  // namespace
