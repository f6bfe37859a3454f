// SPDX-License-Identifier: MIT
// The section of a workspace: its place and its boundary against homogeneous matrices, its volume against
// bodies that have one and against sampling.
#include "report/workspace.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "model/evaluate.h"
#include "printed.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using std::numbers::pi;

model::Robot robot_of(const std::string& name) { return description::read_file(file_of(name)).robot.value(); }

/// Printed formulas of a known robot at joint values, and its chain.
struct Sample {
  Sample(const std::string& robot, std::mt19937& random)
      : chain(reference::load(file_of(robot))), q(chain.size()) {
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (const auto& [name, value] : model::default_bindings(robot_of(robot)))
      values[name] = model::to_double(value);
    for (Eigen::Index i = 0; i < q.size(); ++i)
      values[chain.joints[static_cast<std::size_t>(i)].variable] = q[i] = uniform(random);
  }
  reference::Chain chain;
  reference::VectorXd q;
  reference::Values values;
};

TEST(Workspace, PrintsWhereThePointIs) {
  std::mt19937 random(1);
  for (const char* robot : {"rrr", "rrp", "puma560", "stanford"}) {
    const Sample at(robot, random);
    const Printed printed(report::workspace_lines(robot_of(robot), emit::Notation::text), at.values);
    const auto places = reference::joint_places(at.chain, at.q);
    // Axes 5 and 6 of both arms pass the wrist centre where their frames have their origins.
    const reference::Vector3d point =
        at.q.size() == 6 ? places[5].point : reference::forward_kinematics(at.chain, at.q).translation();
    const reference::Vector3d from = point - places[0].point;
    const double h = from.dot(places[0].axis);
    EXPECT_NEAR(printed.at("h"), h, 1e-9) << robot;
    EXPECT_NEAR(std::hypot(printed.at("u"), printed.at("v")), (from - h * places[0].axis).norm(), 1e-9)
        << robot;
  }
}

/// The factors' product is the Jacobian's determinant, but for a number.
TEST(Workspace, BoundaryIsWhereTheJacobianIsSingular) {
  std::mt19937 random(2);
  std::vector<double> ratios;
  for (int i = 0; i < 5; ++i) {
    const Sample at("rrr", random);
    double product = 1;
    for (std::string line : report::workspace_lines(robot_of("rrr"), emit::Notation::text)) {
      const std::size_t zero = line.find(" = 0");
      if (zero == std::string::npos || line.front() == 'u') continue;
      product *= Printed({"f = " + line.substr(0, zero)}, at.values).at("f");
    }
    ratios.push_back(product / reference::determinant(reference::jacobian(at.chain, at.q).topRows<3>()));
  }
  for (const double ratio : ratios) EXPECT_NEAR(ratio, ratios.front(), 1e-9 * std::abs(ratio));
  EXPECT_NEAR(std::abs(ratios.front()), 1 / (0.4 * 0.3), 1e-9);
}

report::WorkspaceNumbers numbers_of(const std::string& first, const std::string& third) {
  const std::string text =
      "name = \"arm\"\ntitle = \"arm\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = "
      "\"theta1\"\n" +
      first +
      "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"theta2\"\n"
      "link = [0.4, 0, 0]\n[[joint]]\naxis = \"+" +
      third;
  const auto robot = description::read_text(text, "arm.toml").robot.value();
  return report::workspace_numbers(robot, report::workspace_section(robot)).value();
}

TEST(Workspace, OfTwoLinksIsAShell) {
  const std::string elbow = "y\"\ntype = \"revolute\"\nvariable = \"theta3\"\nlink = [0.3, 0, 0]\n";
  const auto whole = numbers_of("", elbow);
  const double shell = 4 * pi / 3 * (0.343 - 0.001);
  EXPECT_NEAR(whole.volume, shell, 5e-3 * shell);
  EXPECT_NEAR(whole.farthest, 0.7, 1e-9);
  EXPECT_NEAR(whole.nearest, 0.1, 1e-9);
  EXPECT_NEAR(whole.narrowest, 0, 1e-9);
  EXPECT_NEAR(whole.lowest, -0.7, 1e-9);
  const auto half = numbers_of("limits = [\"-90 deg\", \"90 deg\"]\n", elbow);
  EXPECT_NEAR(half.volume, whole.volume / 2, 1e-9);
  const auto slide = numbers_of("", "x\"\ntype = \"prismatic\"\nvariable = \"d3\"\nlimits = [-0.1, 0.2]\n");
  EXPECT_NEAR(slide.volume, 4 * pi / 3 * (0.216 - 0.027), 5e-3 * slide.volume);
  EXPECT_NEAR(slide.nearest, 0.3, 1e-9);
}

/// A point is reached if two links of 0.4 and 0.3 m can, in the plane beside the axis by 0.2 m.
TEST(Workspace, VolumeIsThatOfSampledPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.8, 0.8);
  constexpr int samples = 400'000;
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    const double square = x * x + y * y - 0.04;
    const double reach = square + z * z;
    inside += square >= 0 && reach <= 0.49 && reach >= 0.01 ? 1 : 0;
  }
  const double volume = 1.6 * 1.6 * 1.6 * inside / samples;
  const model::Robot rrr = robot_of("rrr");
  EXPECT_NEAR(report::workspace_numbers(rrr, report::workspace_section(rrr))->volume, volume, 0.01 * volume);
}

TEST(Workspace, SaysWhyThereIsNone) {
  EXPECT_NE(report::workspace_section(robot_of("iiwa14")).missing.find("neither three joints nor six"),
            std::string::npos);
  EXPECT_NE(report::workspace_section(robot_of("finger")).missing.find("follows"), std::string::npos);
  EXPECT_NE(report::workspace_section(robot_of("ss")).missing.find("slides"), std::string::npos);
  EXPECT_NE(report::workspace_section(robot_of("ur5")).missing.find("do not meet"), std::string::npos);
  EXPECT_NE(report::workspace_section(robot_of("planar_3r")).missing.find("no volume"), std::string::npos);
  const model::Robot stanford = robot_of("stanford");
  EXPECT_FALSE(report::workspace_numbers(stanford, report::workspace_section(stanford)))
      << "a slide without limits";
}

}  // namespace
}  // namespace qvgen::test
