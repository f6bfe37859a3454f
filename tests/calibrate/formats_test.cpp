// SPDX-License-Identifier: MIT
// Files written besides descriptions: the input's URDF, read here by a reader of the tests' own, and rows
// of Denavit and Hartenberg, multiplied here. Data without noise must give the true arm.
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/dh.h"
#include "calibrate/urdf.h"
#include "patterns.h"
#include "simulate.h"

namespace calibrate_test {
namespace {

using testing::HasSubstr;

const char* const urdf = R"(<?xml version="1.0"?>
<!-- an arm of a test, with what calibration has no business with -->
<robot name="arm">
  <link name="base"><visual><geometry><mesh filename="package://arm/base.stl"/></geometry></visual></link>
  <link name="l1"/> <link name="l2"/> <link name="l3"/>
  <link name="bracket"><inertial><mass value="0.2"/><origin xyz="0 0 0.01"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="l4"/> <link name="l5"/> <link name="l6"/> <link name="tool0"/> <link name="camera"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/>
    <origin xyz="0 0 0.1"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
  <joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/>
    <origin rpy="0 1.5708 0" xyz="0 0.12 0.3" /><axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
  <joint name="j3" type="revolute"><parent link="l2"/><child link="l3"/>
    <axis xyz="0 1 0"/><origin xyz="0 -0.1 0.4"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
  <joint name="mount" type="fixed"><parent link="l3"/><child link="bracket"/><origin xyz="0 0 0.2" rpy="0 0.78539816 0.3"/></joint>
  <joint name="j4" type="continuous"><parent link="bracket"/><child link="l4"/><axis xyz="0.70711 0.70711 0"/></joint>
  <joint name="j5" type="revolute"><parent link="l4"/><child link="l5"/>
    <origin xyz="0 0.11 0" rpy="1.57079 0 0"/><axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
  <joint name="j6" type="revolute"><parent link="l5"/><child link="l6"/>
    <origin xyz="0.02 0 0.09"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="10" velocity="2"/></joint>
  <!-- the flange --><joint name="flange" type="fixed"><parent link="l6"/><child link="tool0"/><origin xyz="0 0 0.05"/></joint>
  <joint name="seeing" type="fixed"><parent link="l4"/><child link="camera"/><origin xyz="0.1 0 0"/></joint>
</robot>
)";

Vector3d numbers(const std::string& element, const std::string& key, const Vector3d& otherwise) {
  const auto found = patterns::first(element, key + "=\"([^\"]*)\"");
  if (!found) return otherwise;
  std::istringstream stream(found->groups[1]);
  Vector3d result;
  stream >> result[0] >> result[1] >> result[2];
  return result;
}

/// Reads the joints of a URDF from base to tip.
reference::Chain chain_of(const std::string& text, std::string tip) {
  std::vector<std::string> path;
  for (bool more = true; more;) {
    more = false;
    for (const patterns::Match& each : patterns::all(text, "<joint [^]*?</joint>")) {
      const std::string& element = each.groups[0];
      if (element.find("<child link=\"" + tip + "\"") == std::string::npos) continue;
      path.insert(path.begin(), element);
      tip = patterns::first(element, "<parent link=\"([^\"]*)\"").value().groups[1];
      more = true;
      break;
    }
  }
  reference::Chain chain;
  Isometry3d before = Isometry3d::Identity();
  for (const std::string& element : path) {
    Isometry3d at = Isometry3d::Identity();
    if (const auto origin = patterns::first(element, "<origin[^>]*>")) {
      const Vector3d rpy = numbers(origin->groups[0], "rpy", Vector3d::Zero());
      at.translation() = numbers(origin->groups[0], "xyz", Vector3d::Zero());
      at.linear() =
          (Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
           Eigen::AngleAxisd(rpy[0], Vector3d::UnitX()))
              .toRotationMatrix();
    }
    before = before * at;
    if (element.find("type=\"fixed\"") != std::string::npos) continue;
    const auto axis = patterns::first(element, "<axis[^>]*>");
    reference::Joint moving;
    moving.variable = "q" + std::to_string(chain.joints.size());
    moving.before = before;
    moving.axis = numbers(axis ? axis->groups[0] : "", "xyz", Vector3d::UnitX()).normalized();
    chain.joints.push_back(moving);
    before.setIdentity();
  }
  chain.tool = before;
  return chain;
}

/// Returns a scene whose true arm errs at every joint and at the tool.
Scene scene_of_urdf(const std::string& text, const qvgen::description::ReadOptions& options) {
  const auto read = qvgen::description::read_text(text, "arm.urdf", options);
  EXPECT_TRUE(read.robot) << to_string(read.diagnostics.front());
  Scene scene;
  scene.robot = read.robot.value();
  scene.truth = scene.nominal = chain_of(text, options.tip);
  std::uniform_real_distribution<double> error(-2e-3, 2e-3);
  const auto small = [&] {
    const Vector3d turn(error(scene.random), error(scene.random), error(scene.random));
    const Vector3d by(error(scene.random), error(scene.random), error(scene.random));
    return Isometry3d(Eigen::Translation3d(by) * Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  };
  for (reference::Joint& joint : scene.truth.joints) joint.before = joint.before * small();
  scene.truth.tool = scene.truth.tool * small();
  scene.targets = {Isometry3d::Identity()};
  return scene;
}

Calibration found_of(const Scene& scene) {
  DataError error;
  auto found = calibrate(scene.robot, measure(scene, 60), {Errors::all, false, true, true}, error);
  if (!found) throw std::runtime_error(error.message + "; " + error.hint);
  return std::move(*found);
}

double difference(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::string without_changes(const std::string& text) {
  const std::string bare = patterns::replaced(text, "<(origin|axis)[^>]*>", "");
  return patterns::replaced(bare, "\\n *<!-- (Origins[^>]*)>|[ \\n]+", "");
}

TEST(Urdf, TheTrueArmIsWrittenAndAllElseIsKept) {
  for (const char* snap : {"auto", "off"}) {
    const qvgen::description::ReadOptions options{.tip = "tool0",
                                                  .snap = qvgen::description::parse_snap(snap).value()};
    const Scene scene = scene_of_urdf(urdf, options);
    const std::string text =
        calibrated_urdf(urdf, options, found_of(scene), "Origins of a test -- a comment.");
    const reference::Chain chain = chain_of(text, "tool0");
    for (int i = 0; i < 20; ++i) {
      const VectorXd q = random_joints(scene);
      EXPECT_LT(
          difference(reference::forward_kinematics(chain, q), reference::forward_kinematics(scene.truth, q)),
          1e-8)
          << text;
    }
    EXPECT_TRUE(qvgen::description::read_text(text, "arm.urdf", options).robot);
    EXPECT_EQ(without_changes(text), without_changes(urdf));
    EXPECT_THAT(text, HasSubstr("<origin xyz=\"0.1 0 0\"/></joint>"))
        << "a camera beside the chain moved on its link";
    EXPECT_THAT(text, HasSubstr("<!-- Origins of a test - - a comment. -->"));
  }
}

TEST(Urdf, ATipThatMovesGetsALinkBehindIt) {
  const qvgen::description::ReadOptions options{.tip = "l6"};
  const Scene scene = scene_of_urdf(urdf, options);
  const std::string text = calibrated_urdf(urdf, options, found_of(scene), "");
  EXPECT_THAT(text, HasSubstr("<link name=\"l6_calibrated\"/>"));
  const reference::Chain chain = chain_of(text, "l6_calibrated");
  const VectorXd q = random_joints(scene);
  EXPECT_LT(
      difference(reference::forward_kinematics(chain, q), reference::forward_kinematics(scene.truth, q)),
      1e-8);
}

TEST(Urdf, AnExactArmStaysWhereItIs) {
  const qvgen::description::ReadOptions options{.tip = "tool0",
                                                .snap = {qvgen::description::SnapOptions::off}};
  Scene scene = scene_of_urdf(urdf, options);
  scene.truth = scene.nominal;
  const reference::Chain chain = chain_of(calibrated_urdf(urdf, options, found_of(scene), ""), "tool0");
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    EXPECT_LT(difference(chain.joints[i].before, scene.nominal.joints[i].before), 1e-9) << i;
}

TEST(Urdf, OtherTextIsRefused) {
  const qvgen::description::ReadOptions options{.tip = "tool0"};
  const Calibration found = found_of(scene_of_urdf(urdf, options));
  EXPECT_THROW(calibrated_urdf("name = \"arm\"", options, found, ""), std::runtime_error);
  EXPECT_THROW(calibrated_urdf("<mujoco/>", options, found, ""), std::runtime_error);
}

/// Multiplies the rows out.
Isometry3d pose_of(const DhRows& rows, const reference::Chain& chain, const VectorXd& q) {
  Isometry3d at = rows.base;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    const DhRow& row = rows.rows[i];
    const bool turns = chain.joints[i].revolute;
    const double value = q[static_cast<Eigen::Index>(i)];
    at = at * Eigen::AngleAxisd(row.theta + (turns ? value : 0), Vector3d::UnitZ()) *
         Eigen::Translation3d(row.a, 0, row.d + (turns ? 0 : value)) *
         Eigen::AngleAxisd(row.alpha, Vector3d::UnitX()) * Eigen::AngleAxisd(row.beta, Vector3d::UnitY());
  }
  return at * rows.tool;
}

TEST(Dh, RowsAreTheTrueArm) {
  for (const char* robot : {"ur5", "scara", "iiwa14", "puma560", "stanford"})
    for (const DhForm form : {DhForm::classic, DhForm::hayati}) {
      const Scene scene = scene_of(robot, 3);
      const Calibration found = found_of(scene);
      const DhChange change = dh_change(found, form);
      for (int i = 0; i < 10; ++i) {
        const VectorXd q = random_joints(scene);
        EXPECT_LT(
            difference(pose_of(change.after, scene.truth, q), reference::forward_kinematics(scene.truth, q)),
            1e-7)
            << robot;
        EXPECT_LT(difference(pose_of(change.before, scene.truth, q),
                             reference::forward_kinematics(scene.nominal, q)),
                  1e-9)
            << robot;
      }
      EXPECT_THAT(dh_text(change, form), HasSubstr("joint, theta [rad], d [m]"));
    }
}

TEST(Dh, HayatisRowsChangeByLittle) {
  for (const char* robot : {"ur5", "scara"}) {
    const DhChange change = dh_change(found_of(scene_of(robot, 3)), DhForm::hayati);
    for (std::size_t i = 0; i + 1 < change.after.rows.size(); ++i) {
      const DhRow &from = change.before.rows[i], &to = change.after.rows[i];
      // Axes on one line: the normal may point anywhere when they are apart.
      if (std::abs(from.a) < 1e-9 && std::abs(std::sin(from.alpha)) < 1e-9) continue;
      for (const double turn : {to.theta - from.theta, to.alpha - from.alpha})
        EXPECT_LT(std::abs(std::remainder(turn, 2 * std::numbers::pi)), 0.1) << robot << i;
      for (const double by : {to.d - from.d, to.a - from.a, to.beta - from.beta})
        EXPECT_LT(std::abs(by), 0.05) << robot << i;
    }
  }
}

}  // namespace
}  // namespace calibrate_test
