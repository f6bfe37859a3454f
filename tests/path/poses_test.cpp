// SPDX-License-Identifier: MIT
// Tables of poses: notations and units mean the same pose; mistakes come with their line.
#include "path/poses.h"

#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <qvgen/orientation.h>
#include <qvgen/pose.h>

namespace qvgen::path {
namespace {

Poses read(const std::string& text, double speed = 0) {
  std::istringstream stream(text);
  PoseOptions options;
  options.speed = speed;
  return read_poses(stream, "seam.csv", options);
}

std::string mistakes(const Poses& poses) {
  std::string text;
  for (const auto& each : poses.diagnostics) text += description::to_string(each) + "\n";
  return text;
}

void expect_mistake(const std::string& text, const std::string& wanted) {
  const Poses poses = read(text);
  EXPECT_FALSE(poses.good()) << text;
  EXPECT_NE(mistakes(poses).find(wanted), std::string::npos) << mistakes(poses);
}

TEST(PathPoses, EveryNotationIsTheSameQuarterTurn) {
  for (const std::string text :
       {"x [mm],y [mm],z [mm],roll [deg],pitch [deg],yaw [deg]\n100,200,300,0,0,90\n",
        "x,y,z,rx,ry,rz\n0.1,0.2,0.3,0,0,1.5707963267948966\n",
        "qw qx qy qz x [m] y [m] z [m]\n0.70710678 0 0 0.70710678 0.1 0.2 0.3\n",
        "x;y;z;qw;qx;qy;qz\n0.1;0.2;0.3;-0.7071067811865476;0;0;-0.7071067811865476\n"}) {
    const Poses poses = read(text);
    ASSERT_TRUE(poses.good()) << mistakes(poses);
    ASSERT_EQ(poses.samples.size(), 1U);
    const Sample& sample = poses.samples[0];
    EXPECT_NEAR(sample.position[0], 0.1, 1e-15);
    EXPECT_NEAR(sample.position[2], 0.3, 1e-15);
    EXPECT_NEAR(std::abs(sample.w), std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(sample.w, sample.z, 1e-9);
    EXPECT_TRUE(std::isnan(sample.time));
  }
}

/// Directions of the tool's z axis: it has them, and turns from pose to pose by no more than they do.
TEST(PathPoses, AnAxisLeavesTheTurnAboutItAsItIs) {
  std::string text = "x,y,z,ax,ay,az\n";
  for (int i = 0; i <= 40; ++i) {
    const double a = 0.07 * i;
    text +=
        fmt::format("0.5,0.01,{},{},{},{}\n", 0.01 * i, 3 * std::sin(a), std::sin(2 * a), -3 * std::cos(a));
  }
  const Poses poses = read(text);
  ASSERT_TRUE(poses.good()) << mistakes(poses);
  Quaternion<double> before;
  for (std::size_t i = 0; i < poses.samples.size(); ++i) {
    const Sample& sample = poses.samples[i];
    const Quaternion<double> q(sample.w, sample.x, sample.y, sample.z);
    const double a = 0.07 * static_cast<double>(i);
    const Vector3<double> axis = q * Vector3<double>(0, 0, 1),
                          wanted = Vector3<double>(3 * std::sin(a), std::sin(2 * a), -3 * std::cos(a))
                                       .normalized();
    EXPECT_LT((axis - wanted).norm(), 1e-12);
    if (i > 0) {
      const double turned = angular_distance<double>(before, q),
                   needed = std::acos((before * Vector3<double>(0, 0, 1)).dot(axis));
      EXPECT_NEAR(turned, needed, 1e-7);
    }
    before = q;
  }
  expect_mistake("x,y,z,ax,ay,az\n0,0,0,0,0,1\n0,0,0.1,0,0,0\n",
                 "seam.csv:3:1: error: the tool's axis has the length 0");
}

TEST(PathPoses, MistakesHaveTheirLine) {
  expect_mistake("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,nan,0,1,0,0,0\n", "seam.csv:3");
  expect_mistake("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,0,0,0,0\n",
                 "seam.csv:3:1: error: the quaternion has the length 0");
  expect_mistake("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,0,1,0,0\n",
                 "seam.csv:3:1: error: the tool turns by half a revolution");
  expect_mistake("x,y,z,qw,qx,qy,qz,t\n0,0,0,1,0,0,0,1\n\n0,0,1,1,0,0,0,0.5\n",
                 "seam.csv:4:1: error: t = 0.5 s is not behind");
  expect_mistake("x,y,z\n0,0,0\n", "no orientation");
  expect_mistake("x,y,z,qw,qx,qy\n0,0,0,1,0,0\n", "a part of one");
  expect_mistake("x,y,z,qw,qx,qy,qz,rx,ry,rz\n0,0,0,1,0,0,0,0,0,0\n", "several notations");
  expect_mistake("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n512,0,300,1,0,0,0\n",
                 "seam.csv:3:1: error: a position of 512 0 300 m");
  expect_mistake("", "seam.csv");
}

TEST(PathPoses, OddRowsAreWarnedOf) {
  std::string text = "x,y,z,qw,qx,qy,qz\n";
  for (int i = 0; i < 10; ++i) text += std::to_string(0.001 * i) + ",0,0,1,0,0,0\n";
  const Poses twice = read(text + "0.009,0,0,1,0,0,0\n"),
              far = read(text + "0.5,0,0,1,0,0,0\n0.501,0,0,1,0,0,0\n");
  EXPECT_TRUE(twice.good());
  EXPECT_NE(mistakes(twice).find("seam.csv:12:1: warning: the pose before once more"), std::string::npos);
  EXPECT_TRUE(far.good());
  EXPECT_NE(mistakes(far).find("seam.csv:12:1: warning: a step of 0.491 m"), std::string::npos)
      << mistakes(far);
  EXPECT_EQ(mistakes(read(text)), "");
}

TEST(PathPoses, ASpeedGivesTimes) {
  const Poses poses = read("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0.3,0,0.4,1,0,0,0\n0.3,0,0.9,1,0,0,0\n", 0.25);
  ASSERT_TRUE(poses.timed);
  EXPECT_DOUBLE_EQ(poses.samples[1].time, 2);
  EXPECT_DOUBLE_EQ(poses.samples[2].time, 4);
  EXPECT_DOUBLE_EQ(poses.length(), 1);
  EXPECT_FALSE(read("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,0.8,0.6,0,0\n", 0.25).good());
}

TEST(PathPoses, ManyPosesAreRead) {
  std::string text = "x,y,z,qw,qx,qy,qz\n";
  for (int i = 0; i < 100000; ++i) text += std::to_string(i % 1000) + "e-3,0.1,0.2,1,0,0,0\n";
  EXPECT_EQ(read(text).samples.size(), 100000U);
}

}  // namespace
}  // namespace qvgen::path
