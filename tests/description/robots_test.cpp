// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "evaluation.h"

namespace qvgen::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

std::vector<std::filesystem::path> robot_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<double> random_joints(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  std::vector<double> q(count);
  for (double& entry : q) entry = angle(random);
  return q;
}

TEST(Robots, AllAreReadWithoutAWarning) {
  std::vector<description::ReadResult> all;
  for (const auto& file : robot_files()) {
    all.push_back(description::read_file(file, {.strict = true}));
    for (const auto& diagnostic : all.back().diagnostics) ADD_FAILURE() << to_string(diagnostic);
    ASSERT_TRUE(all.back().robot) << file;
    EXPECT_EQ(all.back().robot->name, file.stem().string());
    EXPECT_FALSE(all.back().robot->source.empty()) << file;
  }
  EXPECT_GE(all.size(), 28U);
  EXPECT_TRUE(description::check_together(all).empty());
}

TEST(Robots, HaveADefaultForEverySymbolOfTheirGeometryAndFinitePoses) {
  for (const auto& file : robot_files()) {
    const auto robot = description::read_file(file).robot.value();
    for (const auto& parameter : robot.geometry)
      EXPECT_TRUE(parameter.default_value) << file << parameter.name;
    const Values values = default_values(robot);
    const Isometry3d pose = tool_pose(robot, random_joints(robot.joints.size(), 3), values);
    EXPECT_TRUE(pose.matrix().allFinite()) << file;
    EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12) << file;
  }
}

std::string structure(const model::Robot& robot) {
  std::string letters;
  for (const auto& joint : robot.joints) letters += joint.type == model::JointType::revolute ? 'R' : 'P';
  return letters;
}

TEST(Robots, CodesHaveTheirStructures) {
  const std::map<std::string, std::string> arms{{"ss", "PPP"}, {"sc", "PPR"}, {"sn", "PRR"}, {"cs", "RPP"},
                                                {"cc", "RPR"}, {"cr", "RPR"}, {"ns", "RRP"}, {"nn", "RRR"},
                                                {"nr", "RRR"}, {"rc", "RPR"}, {"rn", "RRR"}, {"rr", "RPR"},
                                                {"rs", "RRP"}, {"sr", "PRR"}, {"cn", "PRR"}, {"nc", "RRP"}};
  for (const auto& [code, arm] : arms) EXPECT_EQ(structure(robot_named(code)), arm + "RRR") << code;
}

/// Equation (3.48)'s position, corrected: the arm of NS by hand.
TEST(Robots, NsByHand) {
  const model::Robot robot = robot_named("ns");
  const auto q = random_joints(6, 5);
  const double h1 = 0.5;
  const double d2 = 0.2;
  const Vector3d arm = AngleAxisd(q[0], Vector3d::UnitZ()) *
                       (Vector3d(0, -d2, 0) + AngleAxisd(q[1], -Vector3d::UnitY()) * Vector3d(0, 0, q[2]));
  EXPECT_LT((tool_pose(robot, q, default_values(robot)).translation() - arm - Vector3d(0, 0, h1)).norm(),
            1e-14);
}

TEST(Robots, ScrewsAreAProductOfExponentials) {
  const model::Robot robot = robot_named("poe_6r");
  const Values v = default_values(robot);
  const double height = v.at("a1") + v.at("a2") + v.at("a3");
  const double reach = v.at("d1") + v.at("d2");
  const std::vector<Vector3d> axes{Vector3d::UnitZ(), Vector3d::UnitY(), Vector3d::UnitY(),
                                   Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitX()};
  const Vector3d wrist(reach, 0, height);
  const std::vector<Vector3d> points{Vector3d::Zero(),
                                     Vector3d(v.at("d1"), 0, v.at("a1")),
                                     Vector3d(v.at("d1"), 0, v.at("a1") + v.at("a2")),
                                     wrist,
                                     wrist,
                                     wrist};
  const auto q = random_joints(6, 7);
  Isometry3d pose = Isometry3d::Identity();
  for (std::size_t i = 0; i < 6; ++i) {
    pose = pose * Translation3d(points[i]) * AngleAxisd(q[i], axes[i]) * Translation3d(-points[i]);
  }
  pose = pose * Translation3d(reach + v.at("d3"), 0, height);
  EXPECT_LT((tool_pose(robot, q, v).matrix() - pose.matrix()).norm(), 1e-14);
}

Isometry3d origin(const Vector3d& xyz, const Vector3d& rpy) {
  return Translation3d(xyz) * AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
         AngleAxisd(rpy.y(), Vector3d::UnitY()) * Isometry3d(AngleAxisd(rpy.x(), Vector3d::UnitX()));
}

TEST(Robots, RollPitchYawTurnsAboutFixedAxes) {
  constexpr double right = M_PI / 2;
  const std::vector<Isometry3d> origins{
      origin({0, 0, 0.1575}, {0, 0, 0}),         origin({0, 0, 0.2025}, {right, 0, M_PI}),
      origin({0, 0.2045, 0}, {right, 0, M_PI}),  origin({0, 0, 0.2155}, {right, 0, 0}),
      origin({0, 0.1845, 0}, {-right, M_PI, 0}), origin({0, 0, 0.2155}, {right, 0, 0}),
      origin({0, 0.081, 0}, {-right, M_PI, 0})};
  const model::Robot robot = robot_named("iiwa14");
  const auto q = random_joints(7, 9);
  Isometry3d pose = Isometry3d::Identity();
  for (std::size_t i = 0; i < 7; ++i) pose = pose * origins[i] * AngleAxisd(q[i], Vector3d::UnitZ());
  pose = pose * Translation3d(0, 0, 0.045);
  EXPECT_LT((tool_pose(robot, q, {}).matrix() - pose.matrix()).norm(), 1e-13);
}

TEST(Robots, Irb6640AtZero) {
  const Isometry3d pose = tool_pose(robot_named("irb6640"), std::vector<double>(6), {});
  EXPECT_LT((pose.translation() - Vector3d(0.32 + 1.1425 + 0.2, 0, 0.78 + 1.075 + 0.2)).norm(), 1e-14);
}

}  // namespace
}  // namespace qvgen::test
