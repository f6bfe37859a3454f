// SPDX-License-Identifier: MIT
// The regressor with drives of random trees, on a base that stands still and on one that floats: with any
// inertias, rotors, friction and offsets its product with the parameters is what the tests' own recursion
// gives.
#include "derive/dynamics/drive_regressor.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "derive/dynamics/drive_parameters.h"
#include "floating_motion.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test::trees {
namespace {

using derive::dynamics::DriveRegressor;
using reference::Chain;

/// Kinds of trees repeat after twelve: joints that follow, composed ones, and so on.
const unsigned trees = std::max(12U, tree_count() / 8);

double sign(double x) { return x < 0 ? -1 : 1; }

/// Draws inertias and drives anew, and an offset for each joint. `first`: the joint that holds the first
/// body.
struct AnyParameters {
  AnyParameters(Chain& chain, std::size_t first, unsigned seed) : random(seed) {
    for (std::size_t i = first; i < chain.joints.size(); ++i) draw(chain.joints[i]);
    for (reference::Motor& motor : chain.motors) {
      draw_drive(motor);
      motor_offsets.push_back(unit());
    }
  }

  /// Writes the values of the symbols that parameters are made of; a base that floats has no drive.
  void add_to(const Chain& chain, std::size_t first, std::size_t bases, Motion& motion) {
    using namespace derive::dynamics;
    std::size_t standard = 0;
    for (std::size_t i = first; i < chain.joints.size(); ++i)
      for (const double value : standard_of(chain.joints[i]))
        motion.values[standard_parameter(standard++)] = value;
    for (std::size_t i = first + bases; i < chain.joints.size(); ++i) {
      const reference::Joint& joint = chain.joints[i];
      const std::array values{joint.rotor_inertia, joint.viscous_friction, joint.coulomb_friction,
                              offsets[i - first]};
      for (std::size_t k = 0; k < values.size(); ++k)
        motion.values[drive_parameter(i - first - bases, drive_parameters[k])] = values[k];
      // Counts for nothing: the direction of a sum is no argument.
      if (joint.leaders.size() > 1)
        motion.values[drive_parameter(i - first - bases, DriveParameter::coulomb_friction)] = 7;
    }
    const std::size_t joints = chain.joints.size() - first - bases;
    for (std::size_t i = 0; i < chain.motors.size(); ++i) {
      const reference::Motor& motor = chain.motors[i];
      const std::array values{motor.rotor_inertia, motor.viscous_friction, motor.coulomb_friction,
                              motor_offsets[i]};
      for (std::size_t k = 0; k < values.size(); ++k)
        motion.values[drive_parameter(joints + i, drive_parameters[k])] = values[k];
    }
  }

  std::vector<double> offsets;        ///< of joints from the first body's on
  std::vector<double> motor_offsets;  ///< of motors that are no joints

 private:
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  void draw(reference::Joint& joint) {
    const Matrix3d any = Matrix3d::NullaryExpr([&] { return unit(); });
    joint.mass = 3 + 2 * unit();
    joint.centre_of_mass = Vector3d(unit(), unit(), unit());
    joint.inertia = any * any.transpose();
    draw_drive(joint);
    if (joint.leaders.size() > 1) joint.coulomb_friction = 0;
    offsets.push_back(unit());
  }
  void draw_drive(auto& drive) {
    drive.rotor_inertia = 1 + unit();
    drive.viscous_friction = 1 + unit();
    drive.coulomb_friction = 1 + unit();
  }
  static std::array<double, 10> standard_of(const reference::Joint& link) {
    const Vector3d& c = link.centre_of_mass;
    const Matrix3d inertia =
        link.inertia + link.mass * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
    const Vector3d first = link.mass * c;
    return {link.mass,     first.x(),     first.y(),     first.z(),     inertia(0, 0),
            inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(1, 2), inertia(0, 2)};
  }

  std::mt19937 random;
};

/// Adds the senses of all rates.
void add_directions(const model::Robot& robot, Motion& motion) {
  for (const std::string& name : model::variables(robot))
    motion.values[derive::dynamics::direction_of(name)] =
        sign(motion.values.at(derive::dynamics::velocity_of(name)));
}

/// The forces of the joints' offsets, by what drives them.
VectorXd forces_of_offsets(const model::Robot& robot, const AnyParameters& any, Eigen::Index size) {
  const std::vector<double>& offsets = any.offsets;
  VectorXd forces = VectorXd::Zero(size);
  const auto shares = model::shares(robot);
  const std::size_t first = offsets.size() - shares.size();
  const Eigen::Index base = size - static_cast<Eigen::Index>(model::driven_count(robot));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (const model::Share& share : shares[i])
      forces[base + static_cast<Eigen::Index>(share.driven)] +=
          cln::double_approx(share.ratio) * offsets[first + i];
  const std::vector<std::string> names = model::variables(robot);
  for (std::size_t i = 0; i < robot.motors.size(); ++i) {
    const auto place = std::find(names.begin(), names.end(), robot.motors[i].variable) - names.begin();
    forces[base + place] += any.motor_offsets[i];
  }
  return forces;
}

VectorXd product(const DriveRegressor& found, const Motion& motion, Eigen::Index rows) {
  const VectorXd columns = values_of(found.regressor.formulation, motion);
  const auto parameters = dag::evaluate<double>(found.regressor.base_parameters, Leaves{motion.values});
  return Eigen::Map<const MatrixXd>(columns.data(), rows, columns.size() / rows) *
         Eigen::Map<const VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
}

/// Lets the joints of a tree that follow q0 follow motors, too: one or two of them, alone and in sums.
std::string with_motors(std::string text) {
  const std::string alone = "follows = \"q0\"\nratio = \"-3/2\"\n";
  const std::array sums{"2/3 motor_a - 3/2 q0", "1/2 motor_a + motor_b - q0", "-2 motor_b"};
  std::size_t count = 0;
  for (auto at = text.find(alone); at != std::string::npos; at = text.find(alone))
    text.replace(at, alone.size(),
                 fmt::format("follows = \"{}\"\n", sums.at(std::min<std::size_t>(count++, 2))));
  for (const char* motor : {"motor_a", "motor_b"})
    if (text.find(motor) != std::string::npos) text += fmt::format("[[motor]]\nvariable = \"{}\"\n", motor);
  return text;
}

/// Checks a tree without composed joints, and one with them written out for the reference.
void expect_reference(const std::string& text, const std::string& written_out, unsigned seed) {
  const model::Robot robot = read(text);
  const DriveRegressor regressor = derive::dynamics::regressor_with_drives(robot);
  Chain chain = reference::load_text(written_out);
  AnyParameters any(chain, 0, seed);
  Motion motion(robot, seed);
  add_directions(robot, motion);
  any.add_to(chain, 0, 0, motion);
  const VectorXd expected = reference::inverse_dynamics(chain, motion.q, motion.qd, motion.qdd) +
                            forces_of_offsets(robot, any, motion.q.size());
  expect_close(product(regressor, motion, expected.size()), expected, text);
}

/// Joints of random trees follow sums of motors and of other joints.
TEST(TreeRegressorWithDrives, TimesTheParametersIsTheReferenceByMotors) {
  constexpr unsigned with_one = 10, with_two = 4, seeds = 1000;
  unsigned found_one = 0, found_two = 0;
  for (unsigned seed = 1; seed <= seeds && (found_one < with_one || found_two < with_two); ++seed) {
    const std::string text = with_motors(TreeWriter(seed).tree(4 + static_cast<int>(seed % 3), true));
    const std::size_t motors = read(text).motors.size();
    if (motors == 0 || (motors == 1 && found_one == with_one)) continue;
    ++(motors == 1 ? found_one : found_two);
    expect_reference(text, text, seed);
  }
  EXPECT_EQ(found_one, with_one);
  EXPECT_GE(found_two, with_two);
}

/// Drives of motors, and of joints that several move, have columns, but for these joints' Coulomb friction.
TEST(TreeRegressorWithDrives, NamesTheMotorsColumns) {
  const model::Robot robot = read(
      "name = \"pair\"\ntitle = \"Two turns by two motors\"\naccept_unphysical_inertia = true\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"a\"\nfollows = \"1/2 ml + 1/2 mr\"\n"
      "link = [1, 0, 0]\nmass = 1\n[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"b\"\n"
      "follows = \"1/2 ml - 1/2 mr\"\nlink = [1, 0, 0]\nmass = 1\n[[motor]]\nvariable = \"ml\"\n[[motor]]\n"
      "variable = \"mr\"\n");
  const DriveRegressor found = derive::dynamics::regressor_with_drives(robot);
  const auto& names = found.regressor.names;
  for (const char* name : {"Ia_ml", "fv_ml", "fc_ml", "fc_mr"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  for (const char* name : {"fc1", "fc2"}) {
    EXPECT_EQ(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_NE(std::find(found.left_out.begin(), found.left_out.end(),
                        std::string(name) +
                            " has no column, and counts for nothing: several motors move its joint"),
              found.left_out.end());
  }
}

TEST(TreeRegressorWithDrives, TimesTheParametersIsTheReference) {
  for (unsigned seed = 1; seed <= trees; ++seed) {
    const auto written = [&](Composed as) {
      return TreeWriter(seed, seed % 4 == 1 ? as : Composed::none)
          .tree(1 + static_cast<int>(seed % 5), seed % 3 == 0);
    };
    expect_reference(written(Composed::as_one), written(Composed::written_out), seed);
  }
}

/// Six joints stand for the base in the reference: the base's body hangs on the last of them, without drive.
TEST(FloatingRegressorWithDrives, TimesTheParametersIsTheReference) {
  constexpr std::size_t base_joint = 5;
  for (unsigned seed = 1; seed <= trees; ++seed) {
    const auto written = [&](Composed as) {
      return TreeWriter(seed, seed % 4 == 1 ? as : Composed::none)
          .floating_tree(1 + static_cast<int>(seed % 5), seed % 3 == 0);
    };
    const std::string text = written(Composed::as_one).floating;
    const model::Robot robot = read(text);
    const DriveRegressor regressor = derive::dynamics::regressor_with_drives(robot);
    Chain chain = reference::load_text(written(Composed::written_out).with_joints);
    AnyParameters any(chain, base_joint, seed);
    reference::Joint& base_body = chain.joints[base_joint];
    base_body.rotor_inertia = base_body.viscous_friction = base_body.coulomb_friction = 0;
    Motion motion(robot, seed);
    const BaseMotion base(seed + 1000);
    add_base(base, base.q, motion);
    add_directions(robot, motion);
    any.add_to(chain, base_joint, 1, motion);
    const VectorXd of_joints = reference::inverse_dynamics(
        chain, joined(base.q, motion.q), joined(base.qd, motion.qd), joined(base.qdd, motion.qdd));
    const MatrixXd back = reference::inverse(base.by_rates(motion.q.size()));
    const VectorXd expected = back.transpose() * of_joints + forces_of_offsets(robot, any, of_joints.size());
    expect_close(product(regressor, motion, expected.size()), expected, text);
  }
}

/// Each drive has its columns, but for joints that follow: theirs are their leaders'.
TEST(FloatingRegressorWithDrives, HasAColumnForEachDriveParameter) {
  for (const bool followers : {false, true}) {
    const model::Robot robot = read(TreeWriter(9).floating_tree(6, followers).floating);
    const auto tied = robot.joints.size() - model::driven_count(robot);
    EXPECT_EQ(tied > 0, followers);
    const auto links = derive::dynamics::regressor(robot).names.size();
    const DriveRegressor found = derive::dynamics::regressor_with_drives(robot);
    EXPECT_EQ(found.regressor.names.size(), links + 4 * (robot.joints.size() - tied));
    EXPECT_EQ(found.left_out.size(), 4 * tied);
    EXPECT_TRUE(found.dependent.empty());
  }
}

}  // namespace
}  // namespace qvgen::test::trees
