// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "arm.h"
#include "compare.h"
#include "derive/inverse/inverse.h"

// Every arm of arms.txt, read as a URDF and as an MJCF, is what Orocos KDL and MuJoCo read: position,
// Jacobian and dynamics agree. What is read here goes through `qvgen import` to the reference implementation,
// so that writing descriptions is compared too.
namespace arms {
namespace {

namespace description = qvgen::description;

const std::vector<Arm>& table() {
  static const std::vector<Arm> arms = read_table(QVGEN_SOURCE_DIR "/tests/interop/arms.txt");
  return arms;
}

void without_friction(reference::Chain& chain) {
  for (auto& joint : chain.joints) joint.viscous_friction = 0;
}

/// Angles that are no multiples of 15 degrees: nobody can tell what they were before they were rounded.
bool has_other_angles(const Arm& arm) {
  const auto other = [](const Eigen::Vector3d& rpy) {
    return ((rpy / 15).array().round() * 15 != rpy.array()).any();
  };
  return other(arm.tool_rpy) || std::any_of(arm.joints.begin(), arm.joints.end(),
                                            [&](const Joint& joint) { return other(joint.rpy); });
}

TEST(Arms, AreAtLeastSixty) { EXPECT_GE(table().size(), 60U); }

TEST(Arms, AsUrdfAgreeWithKdl) {
  std::mt19937 random(1);
  for (const Arm& arm : table()) {
    SCOPED_TRACE(arm.name);
    auto chain = chain_of(read(urdf(arm), arm.name + ".urdf", description::SnapOptions::off));
    EXPECT_EQ(chain.joints[0].viscous_friction, 0.3);
    without_friction(chain);
    compare(chain, *kdl(urdf(arm)), random);
  }
}

TEST(Arms, AsMjcfAgreeWithMuJoCo) {
  std::mt19937 random(2);
  for (const Arm& arm : table()) {
    SCOPED_TRACE(arm.name);
    const auto chain = chain_of(read(mjcf(arm), arm.name + ".xml", description::SnapOptions::off));
    compare(chain, *mujoco(mjcf(arm)), random);
  }
}

// Files of five digits are read as those of all digits: so the rounding is gone. A calibrated arm keeps its
// own.
TEST(Arms, RoundedAreWhatTheyWere) {
  std::mt19937 random(3);
  for (const Arm& arm : table()) {
    SCOPED_TRACE(arm.name);
    const int digits = has_other_angles(arm) ? 0 : 5;
    auto chain = chain_of(read(urdf(arm, digits), arm.name + ".urdf", description::SnapOptions::automatic));
    without_friction(chain);
    compare(chain, *kdl(urdf(arm)), random);
    compare(chain_of(read(mjcf(arm, digits), arm.name + ".xml", description::SnapOptions::automatic)),
            *mujoco(mjcf(arm)), random);
  }
}

// A wrist, parallel axes, a shoulder: what inverse kinematics is derived from must survive the rounding.
TEST(Arms, RoundedKeepTheStructureForInverseKinematics) {
  for (const std::string name : {"ur5", "kr6_r700", "irb140", "tx90", "lite6", "iiwa7", "rail_kr16"}) {
    SCOPED_TRACE(name);
    const auto arm =
        std::find_if(table().begin(), table().end(), [&](const Arm& a) { return a.name == name; });
    ASSERT_NE(arm, table().end());
    const auto robot = read(urdf(*arm, 5), name + ".urdf", description::SnapOptions::automatic);
    EXPECT_TRUE(qvgen::derive::inverse::derive(robot).found ||
                qvgen::derive::inverse::derive_given(robot).front().found);
  }
}

}  // namespace
}  // namespace arms
