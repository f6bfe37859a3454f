// SPDX-License-Identifier: MIT
#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "evaluation.h"

// Denavit-Hartenberg tables as the literature prints them, multiplied as homogeneous matrices, against the
// model that the reader makes of the robots' files.
namespace qvgen::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double right = M_PI / 2;

struct Row {
  double theta = 0, d = 0, a = 0, alpha = 0;
  char moves = 't';  // 't'heta, 'd', or 'f'ixed
};

Isometry3d standard(const Row& row) {
  return AngleAxisd(row.theta, Vector3d::UnitZ()) * Translation3d(0, 0, row.d) * Translation3d(row.a, 0, 0) *
         Isometry3d(AngleAxisd(row.alpha, Vector3d::UnitX()));
}

Isometry3d modified(const Row& row) {
  return AngleAxisd(row.alpha, Vector3d::UnitX()) * Translation3d(row.a, 0, 0) *
         AngleAxisd(row.theta, Vector3d::UnitZ()) * Isometry3d(Translation3d(0, 0, row.d));
}

Isometry3d product(const std::vector<Row>& table, const std::vector<double>& q,
                   Isometry3d (*step)(const Row&)) {
  Isometry3d pose = Isometry3d::Identity();
  auto variable = q.begin();
  for (Row row : table) {
    if (row.moves == 't') row.theta += *variable++;
    if (row.moves == 'd') row.d += *variable++;
    pose = pose * step(row);
  }
  return pose;
}

void compare(const model::Robot& robot, const std::vector<Row>& table, Isometry3d (*step)(const Row&)) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  const Values values = default_values(robot);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> q(robot.joints.size());
    for (double& entry : q) entry = angle(random);
    const Isometry3d model_pose = tool_pose(robot, q, values);
    ASSERT_LT((model_pose.matrix() - product(table, q, step).matrix()).norm(), 1e-13) << robot.name;
  }
}

TEST(Table, Puma560) {
  compare(robot_named("puma560"),
          {{0, 0.672, 0, right},
           {0, 0, 0.4318, 0},
           {0, 0.15005, 0.0203, -right},
           {0, 0.4318, 0, right},
           {0, 0, 0, -right},
           {}},
          standard);
}

TEST(Table, Stanford) {
  compare(robot_named("stanford"),
          {{0, 0.412, 0, -right},
           {0, 0.154, 0, right},
           {-right, 0, 0.0203, 0, 'd'},
           {0, 0, 0, -right},
           {0, 0, 0, right},
           {}},
          standard);
}

TEST(Table, Ur5) {
  compare(robot_named("ur5"),
          {{0, 0.089159, 0, right},
           {0, 0, -0.425, 0},
           {0, 0, -0.39225, 0},
           {0, 0.10915, 0, right},
           {0, 0.09465, 0, -right},
           {0, 0.0823, 0, 0}},
          standard);
}

TEST(Table, Rx90) {
  compare(robot_named("rx90"),
          {{}, {0, 0, 0, right}, {0, 0, 0.45, 0}, {0, 0.45, 0, -right}, {0, 0, 0, right}, {0, 0, 0, -right}},
          modified);
}

TEST(Table, General6R) {
  const model::Robot robot = robot_named("general_6r");
  const Values v = default_values(robot);
  std::vector<Row> table{{}};
  for (const std::string i : {"2", "3", "4", "5", "6"}) {
    table.push_back({0, v.at("d" + i), v.at("a" + i), v.at("alpha" + i)});
  }
  compare(robot, table, modified);
}

TEST(Table, RRPlanar) {
  compare(robot_named("rr_planar"), {{}, {0, 0, 0.4, 0}, {0, 0, 0.3, 0, 'f'}}, modified);
}

TEST(Table, Rrp) {
  compare(robot_named("rrp"), {{0, 0.5, 0, 0}, {0, 0.2, 0, right}, {0, 0.3, 0, -right, 'd'}}, modified);
}

TEST(Table, Rrr) {
  compare(robot_named("rrr"), {{0, 0.5, 0, 0}, {0, 0.2, 0, -right}, {0, 0, 0.4, 0}, {0, 0, 0.3, 0, 'f'}},
          modified);
}

TEST(Table, Rpp) { compare(robot_named("rpp"), {{}, {0, 0, 0, 0, 'd'}, {0, 0, 0.3, right, 'd'}}, modified); }

/// Offsets, reversed variables, fixed rows in every place, twists that are no right angles.
const char* const awkward = R"(
name = "awkward"
title = "awkward"
convention = "CONVENTION"
[[dh]]
theta = "30 deg"
d = 0.1
a = 0.2
alpha = "45 deg"
[[dh]]
variable = "t1"
theta = "90 deg - t1"
d = 0.3
a = -0.4
alpha = "-60 deg"
[[dh]]
theta = "-20 deg"
d = 0.5
a = 0.6
alpha = "10 deg"
[[dh]]
variable = "d2"
theta = "40 deg"
d = "0.7 - d2"
a = 0.8
alpha = "90 deg"
[[dh]]
theta = "50 deg"
d = 0.9
a = 1.1
alpha = "70 deg"
)";

model::Robot awkward_robot(const std::string& convention) {
  std::string text = awkward;
  text.replace(text.find("CONVENTION"), 10, convention);
  const auto result = description::read_text(text, "awkward.toml");
  for (const auto& diagnostic : result.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value();
}

std::vector<Row> awkward_table(double t1, double d2) {
  constexpr double deg = M_PI / 180;
  return {{30 * deg, 0.1, 0.2, 45 * deg},
          {90 * deg - t1, 0.3, -0.4, -60 * deg},
          {-20 * deg, 0.5, 0.6, 10 * deg},
          {40 * deg, 0.7 - d2, 0.8, 90 * deg},
          {50 * deg, 0.9, 1.1, 70 * deg}};
}

TEST(Table, OffsetsSignsAndFixedRows) {
  for (const auto& [name, step] : {std::pair{"standard", &standard}, std::pair{"modified", &modified}}) {
    const model::Robot robot = awkward_robot(name);
    Isometry3d pose = Isometry3d::Identity();
    std::vector<Isometry3d> frames;
    for (const Row& row : awkward_table(0.37, -1.3)) frames.push_back(pose = pose * step(row));
    const auto links = link_frames(robot, {0.37, -1.3}, {});
    EXPECT_LT((links[0].matrix() - frames[1].matrix()).norm(), 1e-14) << name;
    EXPECT_LT((links[1].matrix() - frames[3].matrix()).norm(), 1e-14) << name;
    EXPECT_LT((tool_pose(robot, {0.37, -1.3}, {}).matrix() - frames[4].matrix()).norm(), 1e-14) << name;
  }
}

}  // namespace
}  // namespace qvgen::test
