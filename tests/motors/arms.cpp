// SPDX-License-Identifier: MIT
// The compiled functions of each arm behind vectors of any length, and what the reference says of them.
#include "arms.h"

#include <map>

#include <qvgen/robots/belt_scara.h>
#include <qvgen/robots/bevel_arm.h>
#include <qvgen/robots/geared_seven.h>
#include <qvgen/robots/nested_wrist.h>
#include <qvgen/robots/palletiser.h>
#include <qvgen/robots/rail_seven.h>
#ifdef QVGEN_ALL_ARMS
#include <qvgen/robots/gantry.h>
#endif

#include "fixed_sizes.h"

namespace qvgen::test {

void Rows::append(const double* q, int dof, int branch, bool continuum) {
  rows.push_back({Eigen::Map<const VectorXd>(q, dof), branch, continuum});
}

Arm::Arm(const std::string& file, InverseInfo of_inverse, std::vector<std::string> of_joints,
         std::vector<int> given_joints, Functions compiled)
    : name(file),
      info(of_inverse),
      names(std::move(of_joints)),
      given(std::move(given_joints)),
      functions(std::move(compiled)),
      chain(reference::load(std::string(QVGEN_MOTOR_ARMS) + "/" + name + ".toml", {})),
      coupling(chain.coupling()),
      dof(static_cast<int>(names.size())) {}

VectorXd Arm::joints(const VectorXd& motors) const { return coupling * motors; }

VectorXd Arm::random_motors(std::mt19937& random, double size) const {
  std::uniform_real_distribution<double> between(-size, size);
  VectorXd motors(dof);
  for (double& motor : motors) motor = between(random);
  return motors;
}

VectorXd Arm::constant(double value) const { return VectorXd::Constant(dof, value); }

double Arm::error_of(const VectorXd& motors, const qvgen::Pose<double>& pose) const {
  const Eigen::Isometry3d tool = reference::forward_kinematics(chain, motors);
  return (tool.linear() - pose.orientation.toRotationMatrix()).norm() +
         (tool.translation() - pose.position).norm();
}

bool Arm::is_same(const VectorXd& a, const VectorXd& b) const {
  const VectorXd difference = joints(a - b);
  for (int i = 0; i < dof; ++i) {
    const double off = is_revolute(i) ? std::remainder(difference[i], 2 * M_PI) : difference[i];
    if (!(std::abs(off) <= 1e-7)) return false;
  }
  return true;
}

double distance(const VectorXd& a, const VectorXd& b) { return (a - b).norm(); }

namespace {

/// Functions of an arm of so many joints: `solve` and `near` take what all given values make of it.
template <int dof, class Solve, class Near>
Functions functions_of(qvgen::Pose<double> (*pose)(const Joints<dof>&), const Solve& solve,
                       const Near& near) {
  Functions all;
  all.pose = [pose](const VectorXd& q) { return pose(fixed<dof>(q)); };
  all.solve = [solve](const VectorXd& at, const qvgen::Pose<double>& target, const Asked& asked) {
    if (asked.seed != nullptr && asked.limits != nullptr)
      return rows_of(solve(at, target, fixed<dof>(*asked.seed), fixed<dof>(*asked.limits)));
    if (asked.seed != nullptr) return rows_of(solve(at, target, fixed<dof>(*asked.seed)));
    if (asked.limits != nullptr) return representatives_of(solve(at, target, fixed<dof>(*asked.limits)));
    return rows_of(solve(at, target));
  };
  all.near = [near](const VectorXd& at, const qvgen::Pose<double>& target, const Asked& asked) {
    if (asked.limits != nullptr)
      return rows_of(near(at, target, fixed<dof>(*asked.seed), fixed<dof>(*asked.limits)));
    return rows_of(near(at, target, fixed<dof>(*asked.seed)));
  };
  return all;
}

// An arm: its name, what its inverse kinematics is called after, and its given values of the motors `at`.
#define QVGEN_TEST_ARM(ARM, SUFFIX, ...)                                                               \
  functions_of<robots::ARM::dof>(                                                                      \
      [](const Joints<robots::ARM::dof>& q) { return robots::ARM::forward_kinematics(q); },            \
      []([[maybe_unused]] const VectorXd& at, const qvgen::Pose<double>& pose, const auto&... more) {  \
        return robots::ARM::inverse_kinematics##SUFFIX(pose __VA_OPT__(, ) __VA_ARGS__, more...);      \
      },                                                                                               \
      []([[maybe_unused]] const VectorXd& at, const qvgen::Pose<double>& pose, const auto&... more) {  \
        return robots::ARM::inverse_kinematics_near##SUFFIX(pose __VA_OPT__(, ) __VA_ARGS__, more...); \
      })

template <class Names>
std::vector<std::string> list(const Names& names) {
  return {names.begin(), names.end()};
}

std::map<std::string, Arm> make_arms() {
  namespace bevel = robots::bevel_arm;
  namespace belt = robots::belt_scara;
  namespace geared = robots::geared_seven;
  namespace nested = robots::nested_wrist;
  namespace palletiser = robots::palletiser;
  namespace rail = robots::rail_seven;
  std::map<std::string, Arm> arms;
  const auto add = [&](const std::string& name, const Arm& arm) { arms.emplace(name, arm); };
  // Bevel gears and a bar: six turns.
  add("bevel_arm",
      {"bevel_arm", bevel::inverse_info, list(bevel::joint_names), {}, QVGEN_TEST_ARM(bevel_arm, )});
  // Four joints, a slide among them, asked for by poses.
  add("belt_scara",
      {"belt_scara", belt::inverse_info, list(belt::joint_names), {}, QVGEN_TEST_ARM(belt_scara, )});
  // Seven joints; the rail, which is a motor, is given.
  add("geared_seven", {"geared_seven",
                       geared::inverse_info_given_rail,
                       list(geared::joint_names),
                       {0},
                       QVGEN_TEST_ARM(geared_seven, _given_rail, at[0])});
  // Six turns; whole turns of the fourth move three motors.
  add("nested_wrist",
      {"nested_wrist", nested::inverse_info, list(nested::joint_names), {}, QVGEN_TEST_ARM(nested_wrist, )});
  // Four motors and six joints, two of them on one line: they keep the tool level.
  add("palletiser", {"palletiser",
                     palletiser::inverse_info,
                     list(palletiser::joint_names),
                     {},
                     QVGEN_TEST_ARM(palletiser, )});
  // Eight joints: the first and one of the inner arm's seven are given.
  add("rail_seven", {"rail_seven",
                     rail::inverse_info_given_rail_theta3,
                     list(rail::joint_names),
                     {0, 3},
                     QVGEN_TEST_ARM(rail_seven, _given_rail_theta3, at[0], at[3])});
  add("rail_seven_by_the_last", {"rail_seven",
                                 rail::inverse_info_given_rail_theta7,
                                 list(rail::joint_names),
                                 {0, 7},
                                 QVGEN_TEST_ARM(rail_seven, _given_rail_theta7, at[0], at[7])});
#ifdef QVGEN_ALL_ARMS
  namespace gantry = robots::gantry;
  // Nine joints: two in front and one behind are given.
  add("gantry", {"gantry",
                 gantry::inverse_info_given_gx_gz_flange,
                 list(gantry::joint_names),
                 {0, 1, 8},
                 QVGEN_TEST_ARM(gantry, _given_gx_gz_flange, at[0], at[1], at[8])});
#endif
  arms.at("belt_scara").functions.jacobian = [](const VectorXd& q) {
    return MatrixXd(belt::jacobian(fixed<belt::dof>(q)));
  };
  arms.at("palletiser").functions.jacobian = [](const VectorXd& q) {
    return MatrixXd(palletiser::jacobian(fixed<palletiser::dof>(q)));
  };
  arms.at("geared_seven").functions.jacobian = [](const VectorXd& q) {
    return MatrixXd(geared::jacobian(fixed<geared::dof>(q)));
  };
  add_functions_in_c(arms);
  return arms;
}

}  // namespace

const Arm& arm_named(const std::string& name) {
  static const std::map<std::string, Arm> arms = make_arms();
  return arms.at(name);
}

}  // namespace qvgen::test
