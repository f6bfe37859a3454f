// SPDX-License-Identifier: MIT
#include "report/chain.h"

#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "report/dh.h"
#include "report/drawing.h"
#include "report/reach.h"

namespace {

using namespace qvgen;
using namespace qvgen::report;

std::vector<model::Robot> known_robots() {
  std::vector<model::Robot> robots;
  for (const auto& file : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots"))
    if (file.path().extension() == ".toml") robots.push_back(*description::read_file(file.path(), {}).robot);
  return robots;
}

Motion by_dh(const Chain& chain, const DhTable& table, const std::vector<double>& q) {
  Motion at = table.base;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const DhRow& row = table.rows[i];
    const bool revolute = chain.joints[i].revolute;
    at = at * turn(Vector::UnitZ(), row.theta + (revolute ? q[i] : 0)) *
         Eigen::Translation3d(row.a, 0, row.d + (revolute ? 0 : q[i])) * turn(Vector::UnitX(), row.alpha);
  }
  return at * table.tool;
}

double difference(const Motion& a, const Motion& b) { return (a.matrix() - b.matrix()).norm(); }

TEST(Dh, GivesThePoseOfEveryKnownRobot) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-3, 3);
  const auto robots = known_robots();
  ASSERT_GT(robots.size(), 30U);
  for (const model::Robot& robot : robots) {
    const Chain chain = chain_of(robot);
    const DhTable table = dh_table(chain);
    for (int i = 0; i < 20; ++i) {
      std::vector<double> q(chain.joints.size());
      for (double& each : q) each = value(random);
      EXPECT_LT(difference(by_dh(chain, table, q), posture_of(chain, q).tool), 1e-9) << robot.name;
    }
  }
}

TEST(Dh, OfPumaAreThePublishedOnes) {
  const auto puma = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/puma560.toml", {}).robot;
  const DhTable table = dh_table(chain_of(*puma));
  const double right = std::acos(0.0);
  const double a[] = {0, 0.4318, 0.0203, 0, 0, 0};
  const double d[] = {0.672, 0, 0.15005, 0.4318, 0, 0};
  const double alpha[] = {right, 0, -right, right, -right, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(table.rows[i].a, a[i], 1e-12);
    EXPECT_NEAR(table.rows[i].d, d[i], 1e-12);
    EXPECT_NEAR(table.rows[i].alpha, alpha[i], 1e-12);
    EXPECT_NEAR(table.rows[i].theta, 0, 1e-12);
  }
}

TEST(Poses, StayWithinLimits) {
  for (const model::Robot& robot : known_robots()) {
    const Chain chain = chain_of(robot);
    for (const auto& q : {zero_pose(chain), bent_pose(chain)})
      for (std::size_t i = 0; i < q.size(); ++i) {
        EXPECT_GE(q[i], range_of(chain, i).first) << robot.name;
        EXPECT_LE(q[i], range_of(chain, i).second) << robot.name;
      }
  }
}

TEST(Reach, OfAPlanarArmIsItsLength) {
  const auto robot = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/rr_planar.toml", {}).robot;
  const Chain chain = chain_of(*robot);
  const Reach reach = reach_of(chain);
  EXPECT_LE(reach.farthest, size_of(chain) + 1e-12);
  EXPECT_GT(reach.farthest, 0.99 * size_of(chain));
  EXPECT_NEAR(reach.lowest, reach.highest, 1e-12);
}

TEST(Drawing, NamesEveryJointAndIsTheSameInEveryRun) {
  const auto robot = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/ns.toml", {}).robot;
  const Chain chain = chain_of(*robot);
  const Caption caption{"figure", "NS < & >", "six joints", true};
  const std::string svg = drawing(chain, bent_pose(chain), caption);
  EXPECT_EQ(svg, drawing(chain, bent_pose(chain), caption));
  for (const char* name : {"θ₁", "θ₂", "d₃", "θ₄", "θ₅", "θ₆"})
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  EXPECT_NE(svg.find("NS &lt; &amp; &gt;"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
