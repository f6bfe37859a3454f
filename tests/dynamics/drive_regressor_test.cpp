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
    }
  }

  std::vector<double> offsets;  ///< of joints from the first body's on

 private:
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  void draw(reference::Joint& joint) {
    const Matrix3d any = Matrix3d::NullaryExpr([&] { return unit(); });
    joint.mass = 3 + 2 * unit();
    joint.centre_of_mass = Vector3d(unit(), unit(), unit());
    joint.inertia = any * any.transpose();
    joint.rotor_inertia = 1 + unit();
    joint.viscous_friction = 1 + unit();
    joint.coulomb_friction = 1 + unit();
    offsets.push_back(unit());
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
VectorXd forces_of_offsets(const model::Robot& robot, const std::vector<double>& offsets, Eigen::Index size) {
  VectorXd forces = VectorXd::Zero(size);
  const auto shares = model::shares(robot);
  const std::size_t first = offsets.size() - shares.size();
  const Eigen::Index base = size - static_cast<Eigen::Index>(model::driven_count(robot));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (const model::Share& share : shares[i])
      forces[base + static_cast<Eigen::Index>(share.driven)] +=
          cln::double_approx(share.ratio) * offsets[first + i];
  return forces;
}

VectorXd product(const DriveRegressor& found, const Motion& motion, Eigen::Index rows) {
  const VectorXd columns = values_of(found.regressor.formulation, motion);
  const auto parameters = dag::evaluate<double>(found.regressor.base_parameters, Leaves{motion.values});
  return Eigen::Map<const MatrixXd>(columns.data(), rows, columns.size() / rows) *
         Eigen::Map<const VectorXd>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
}

TEST(TreeRegressorWithDrives, TimesTheParametersIsTheReference) {
  for (unsigned seed = 1; seed <= trees; ++seed) {
    const auto written = [&](Composed as) {
      return TreeWriter(seed, seed % 4 == 1 ? as : Composed::none)
          .tree(1 + static_cast<int>(seed % 5), seed % 3 == 0);
    };
    const std::string text = written(Composed::as_one);
    const model::Robot robot = read(text);
    const DriveRegressor regressor = derive::dynamics::regressor_with_drives(robot);
    Chain chain = reference::load_text(written(Composed::written_out));
    AnyParameters any(chain, 0, seed);
    Motion motion(robot, seed);
    add_directions(robot, motion);
    any.add_to(chain, 0, 0, motion);
    const VectorXd expected = reference::inverse_dynamics(chain, motion.q, motion.qd, motion.qdd) +
                              forces_of_offsets(robot, any.offsets, motion.q.size());
    expect_close(product(regressor, motion, expected.size()), expected, text);
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
    const VectorXd expected =
        back.transpose() * of_joints + forces_of_offsets(robot, any.offsets, of_joints.size());
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
