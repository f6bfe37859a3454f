// SPDX-License-Identifier: MIT
// Paths of arms whose joints motors move: motions are where some choice of whole turns of the joints has all
// motors, and all joints with limits of their own, inside. Brute force over whole turns says where that is,
// with the relations of joints and motors as the reference reads them.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <qvgen/path/program.h>
#include <qvgen/robots/geared_seven.h>
#include <qvgen/robots/nested_wrist.h>
#include <qvgen/robots/spline_wrist.h>
#include <qvgen/robots/spline_wrist/certified.h>

#include "reference/chain.h"
#include "reference/load.h"

namespace motor_paths {
namespace {

using namespace qvgen;
using namespace qvgen::path;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double turn = 6.283185307179586;

/// An arm as the reference reads it: joints by motors, and which joints have limits of their own.
struct Truth {
  explicit Truth(const std::string& file, int held_joint = -1)
      : chain(reference::load(file, {})), joints_by_motors(chain.coupling()), held(held_joint) {
    motors_by_joints = joints_by_motors.inverse();
  }
  reference::Chain chain;
  MatrixXd joints_by_motors, motors_by_joints;
  int held;              ///< a joint, which is a motor with the same index here; -1 for none
  std::vector<int> own;  ///< joints with limits of their own

  [[nodiscard]] bool is_revolute(int joint) const {
    return chain.joints[static_cast<std::size_t>(joint)].revolute;
  }
  [[nodiscard]] int dof() const { return static_cast<int>(joints_by_motors.rows()); }
  /// Returns the values with limits of all joints: of motors but for the one that is held, then of joints.
  [[nodiscard]] VectorXd limited(const VectorXd& q) const {
    const VectorXd motors = motors_by_joints * q;
    std::vector<double> values;
    for (int i = 0; i < dof(); ++i)
      if (i != held) values.push_back(motors[i]);
    for (const int joint : own) values.push_back(q[joint]);
    return Eigen::Map<VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  [[nodiscard]] VectorXd with_held(const Values& q, double value) const {
    if (held < 0) return q;
    VectorXd all(7);
    all << q.head(held), value, q.tail(6 - held);
    return all;
  }
};

struct Bounds {
  VectorXd lower, upper;
  [[nodiscard]] bool hold(const VectorXd& values) const {
    return (values.array() >= lower.array()).all() && (values.array() <= upper.array()).all();
  }
  [[nodiscard]] bool are_finite() const { return lower.allFinite() && upper.allFinite(); }
};

/// Whole turns of joints from one on that bring all values inside, tried one after the other; without an end
/// of all limits at least one, if there is one.
double inside(const Truth& truth, const Bounds& bounds, int joint, VectorXd& q) {
  if (joint == truth.dof()) return bounds.hold(truth.limited(q)) ? 1 : 0;
  if (joint == truth.held || !truth.is_revolute(joint)) return inside(truth, bounds, joint + 1, q);
  // Bounds of the joint, from those of its motors.
  double low = 0, high = 0;
  for (int i = 0, k = 0; i < truth.dof(); ++i) {
    if (i == truth.held) continue;
    const double share = truth.joints_by_motors(joint, i);
    if (share != 0) {
      low += share > 0 ? share * bounds.lower[k] : share * bounds.upper[k];
      high += share > 0 ? share * bounds.upper[k] : share * bounds.lower[k];
    }
    ++k;
  }
  const double start = q[joint];
  double count = 0;
  const double first = std::ceil((std::max(low, -20.0) - start) / turn),
               last = std::floor((std::min(high, 20.0) - start) / turn);
  for (double n = first; n <= last && (count == 0 || bounds.are_finite()); ++n) {
    q[joint] = start + n * turn;
    count += inside(truth, bounds, joint + 1, q);
  }
  q[joint] = start;
  return count;
}

/// Bounds next to values at some joints: mostly both, seldom one or none.
Bounds random_bounds(const Truth& truth, const VectorXd& at, bool with_open, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const VectorXd values = truth.limited(at);
  Bounds bounds{values, values};
  for (int i = 0; i < values.size(); ++i) {
    double reach = 0.1;  // how far whole turns move the value
    for (int joint = 0; joint < truth.dof(); ++joint) {
      if (joint == truth.held || !truth.is_revolute(joint)) continue;
      VectorXd turned = at;
      turned[joint] += turn;
      reach = std::max(reach, std::abs((truth.limited(turned) - values)[i]));
    }
    const bool is_joint = i >= truth.dof() - (truth.held < 0 ? 0 : 1);
    if (is_joint) reach *= 0.5;
    bounds.lower[i] -= 1.2 * reach * share(random);
    bounds.upper[i] += 1.2 * reach * share(random);
    if (!with_open || is_joint) continue;
    const double fate = share(random);
    if (fate < 0.5) bounds.lower[i] = -infinity;
    if (fate > 0.3 && fate < 0.7) bounds.upper[i] = infinity;
  }
  return bounds;
}

/// Poses of joints that go evenly from some place to another.
template <class Arm>
std::vector<Pose<double>> poses_of(const Arm& arm, const Values& from, const Values& way, int count) {
  std::vector<Pose<double>> poses;
  for (int i = 0; i < count; ++i) poses.push_back(arm.forward(from + way * i / (count - 1)));
  return poses;
}

/// All that is found along one path.
template <class Arm>
struct Whole {
  static constexpr int capacity = Arm::capacity;
  Whole(const Arm& arm, const std::vector<Pose<double>>& samples, const Bounds& bounds)
      : curve(samples.data(), samples.size()),
        q(samples.size() * capacity * 6),
        rows(samples.size() * capacity),
        tracks(4000),
        events(40000),
        record({q.data(), rows.data(), tracks.data(), tracks.size(), events.data(), events.size()}) {
    constexpr int values = Arm::Limited::values;
    JointLimits<values> given{Joints<values>::Zero(), Joints<values>::Zero()};
    given.lower.head(bounds.lower.size()) = bounds.lower;
    given.upper.head(bounds.upper.size()) = bounds.upper;
    limits = arm.coupling.limits(given);
    Follower<Arm>(arm, curve, limits, record).run();
    const auto take = [&](const Motion& motion) { motions.push_back(motion); };
    using Cut = MotionsOf<capacity, decltype(take), typename Arm::Limited>;
    EXPECT_TRUE(std::make_unique<Cut>(record, limits, arm.revolute, take, arm.coupling)->run());
    EXPECT_FALSE(record.is_full);
  }
  Curve curve;
  JointLimits<Arm::Limited::values> limits;
  std::vector<double> q;
  std::vector<int> rows;
  std::vector<Track> tracks;
  std::vector<Event> events;
  Record<capacity> record;
  std::vector<Motion> motions;

  [[nodiscard]] bool is_near_an_end(double s) const {
    return std::any_of(motions.begin(), motions.end(), [&](const Motion& motion) {
      return std::abs(motion.begin.s - s) < 1e-6 || std::abs(motion.end.s - s) < 1e-6;
    });
  }
};

struct Counts {
  int places = 0, motions = 0, ends = 0;
};

/// Ends at limits are on them, in the caller's order of values, and joints at all samples inside.
template <class Arm>
void check_motions(const Truth& truth, const Arm& arm, double value, const Whole<Arm>& whole,
                   const Bounds& bounds, Counts& counts) {
  for (const Motion& motion : whole.motions) {
    ++counts.motions;
    for (const End* end : {&motion.begin, &motion.end}) {
      const VectorXd q = truth.with_held(end->q, value), values = truth.limited(q);
      EXPECT_LT((values.head(6) - arm.coupling.shown(end->q)).norm(), 1e-9);
      EXPECT_LT(linear_distance(arm.forward(end->q), whole.curve.at(end->s)), 1e-7);
      if (end->cause != Cause::limit) continue;
      ++counts.ends;
      const int i = arm.coupling.shown_index(end->partner);
      EXPECT_NEAR(values[i], end->is_upper ? bounds.upper[i] : bounds.lower[i], 1e-7);
    }
    for (std::size_t i = 0; i < whole.curve.samples(); ++i) {
      Values q;
      const auto s = static_cast<double>(i);
      if (s < motion.begin.s || s > motion.end.s || !whole.record.at(i, motion.track, q)) continue;
      const VectorXd values = truth.limited(truth.with_held(q + motion.turns, value));
      EXPECT_TRUE((values.array() >= bounds.lower.array() - 1e-7).all() &&
                  (values.array() <= bounds.upper.array() + 1e-7).all());
    }
  }
}

/// At places that lie dense: as many motions, representatives counted, as brute force finds inside.
template <class Arm>
void check_places(const Truth& truth, const Arm& arm, double value, const Whole<Arm>& whole,
                  const Bounds& bounds, Counts& counts) {
  const int count = bounds.are_finite() ? 200 : 40;
  for (int i = 0; i < count; ++i) {
    const double s = whole.curve.end() * (i + 0.31) / count;
    const auto found = arm.solve(whole.curve.at(s));
    if (found.status != Status::solved || whole.is_near_an_end(s)) continue;
    double all = 0, alive = 0;
    std::size_t rows = 0;
    std::set<int> tracks;
    for (const auto& row : found) {
      VectorXd q = truth.with_held(row.q, value);
      const double here = inside(truth, bounds, 0, q);
      all += here;
      rows += here > 0 ? 1U : 0U;
    }
    for (const Motion& motion : whole.motions) {
      if (!(motion.begin.s < s && s < motion.end.s)) continue;
      alive += motion.representatives;
      tracks.insert(motion.track);
    }
    ++counts.places;
    ASSERT_EQ(tracks.size(), rows) << "s = " << s;
    if (bounds.are_finite()) {
      ASSERT_EQ(alive, all) << "s = " << s;
    }
  }
}

template <class Arm>
void check_arm(const Truth& truth, const Arm& arm, double value) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-2.5, 2.5), way(-1, 1);
  Counts counts;
  for (int k = 0; k < 24; ++k) {
    SCOPED_TRACE("path " + std::to_string(k));
    Values from, step;
    for (int i = 0; i < 6; ++i) {
      const bool turns = arm.revolute[static_cast<std::size_t>(i)];
      from[i] = turns ? anywhere(random) : 0.2;
      step[i] = way(random) * (turns ? 1 : 0.1);
    }
    const std::vector<Pose<double>> poses = poses_of(arm, from, step, 9);
    const Bounds bounds = random_bounds(truth, truth.with_held(from + 0.4 * step, value), k % 3 == 2, random);
    const Whole<Arm> whole(arm, poses, bounds);
    check_motions(truth, arm, value, whole, bounds, counts);
    check_places(truth, arm, value, whole, bounds, counts);
  }
  EXPECT_GT(counts.places, 3000);
  EXPECT_GT(counts.motions, 40);
  EXPECT_GT(counts.ends, 20);
}

/// An arm of six joints, as `qvgen path` writes it.
#define QVGEN_MOTOR_ARM(robot)                                                                \
  path::Arm {                                                                                 \
    [](const Pose<double>& pose) { return robots::robot::joints::inverse_kinematics(pose); }, \
        [](const Values& q) {                                                                 \
          return robots::robot::forward_kinematics<double>(                                   \
              Coupled<robots::robot::detail::MotorMap>().all_motors(q));                      \
        },                                                                                    \
        [](const Values& q) {                                                                 \
          const Coupled<robots::robot::detail::MotorMap> coupling;                            \
          return coupling.by_joints(robots::robot::jacobian<double>(coupling.all_motors(q))); \
        },                                                                                    \
        robots::robot::joints::is_revolute, robots::robot::inverse_info.stable_branches,      \
        Coupled<robots::robot::detail::MotorMap>()                                            \
  }

TEST(MotorPaths, OfNestedShaftsAreWhereTurnsAreInside) {
  Truth truth(QVGEN_MOTOR_ARMS "/nested_wrist.toml");
  truth.own = {4};
  check_arm(truth, QVGEN_MOTOR_ARM(nested_wrist), 0);
}

TEST(MotorPaths, OfABallScrewAreWhereTurnsAreInside) {
  Truth truth(QVGEN_PATH_ARMS "/spline_wrist.toml");
  truth.own = {2};
  check_arm(truth, QVGEN_MOTOR_ARM(spline_wrist), 0);
}

TEST(MotorPaths, WithAHeldMotorAreWhereTurnsAreInside) {
  namespace robot = robots::geared_seven;
  const double rail = 0.3;
  const Truth truth(QVGEN_MOTOR_ARMS "/geared_seven.toml", 0);
  const Held held{0, rail};
  const Coupled<robot::detail::MotorMap> coupling(held, 0);
  const path::Arm arm{
      [held](const Pose<double>& pose) {
        return held.without(robot::joints::inverse_kinematics_given_rail(pose, held.value));
      },
      [coupling](const Values& q) { return robot::forward_kinematics<double>(coupling.all_motors(q)); },
      [coupling](const Values& q) {
        return coupling.by_joints(robot::jacobian<double>(coupling.all_motors(q)));
      },
      held.without(robot::joints::is_revolute),
      robot::inverse_info_given_rail.stable_branches,
      coupling};
  check_arm(truth, arm, rail);
}

/// Rows of motors are proven where rows of joints are: nearness in joints is nearness in motors by the
/// largest sums of the relation's entries, which the reference reads.
TEST(MotorProofs, AreThoseOfTheJoints) {
  namespace robot = robots::spline_wrist;
  const Truth truth(QVGEN_PATH_ARMS "/spline_wrist.toml");
  const double to_motors = truth.motors_by_joints.cwiseAbs().rowwise().sum().maxCoeff();
  const double to_joints = truth.joints_by_motors.cwiseAbs().rowwise().sum().maxCoeff();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-2.5, 2.5), lift(0.05, 0.4);
  int complete = 0, proven = 0;
  constexpr int poses = 40;
  for (int k = 0; k < poses; ++k) {
    Values q;
    for (double& each : q) each = anywhere(random);
    q[2] = lift(random);
    const Values motors = truth.motors_by_joints * q;
    const Pose<double> pose = robot::forward_kinematics<double>(motors);
    const auto of_joints = robot::joints::inverse_kinematics_certified(pose);
    const auto found = robot::inverse_kinematics_certified(pose);
    ASSERT_EQ(found.solutions.size(), of_joints.solutions.size());
    EXPECT_EQ(found.is_complete(), of_joints.is_complete());
    complete += found.is_complete() ? 1 : 0;
    double nearest = infinity, within = 0;
    for (int i = 0; i < found.solutions.size(); ++i) {
      const Values row = truth.joints_by_motors * found.solutions[i].q;
      EXPECT_LT((row - of_joints.solutions[i].q).norm(), 1e-11);
      const double off = difference(row, q, robot::joints::is_revolute).cwiseAbs().maxCoeff();
      const RowProof &motor = found.rows[static_cast<std::size_t>(i)],
                     &joint = of_joints.rows[static_cast<std::size_t>(i)];
      if (off < nearest) within = motor.within;
      nearest = std::min(nearest, off);
      ASSERT_EQ(motor.proven, joint.proven);
      if (!motor.proven) continue;
      ++proven;
      EXPECT_GE(motor.within, to_motors * joint.within);
      EXPECT_LT(motor.within, to_motors * joint.within + 1e-9);
      EXPECT_LE(motor.alone_within, joint.alone_within / to_joints);
      EXPECT_GT(motor.alone_within, 0.9 * joint.alone_within / to_joints);
    }
    if (found.is_complete()) {
      EXPECT_LT(nearest, within + 1e-9);
    }
  }
  EXPECT_GT(complete, poses - 4);
  EXPECT_GT(proven, 2 * poses);
}

/// The Jacobian by joints is that of the pose.
TEST(MotorPaths, HaveTheJacobianByJoints) {
  const auto arm = QVGEN_MOTOR_ARM(spline_wrist);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-2, 2);
  for (int k = 0; k < 50; ++k) {
    Values q;
    for (double& each : q) each = anywhere(random);
    const auto jacobian = arm.jacobian(q);
    for (int i = 0; i < 6; ++i) {
      const double h = 1e-6;
      const Pose<double> a = arm.forward(q - h * Values::Unit(i));
      const Pose<double> b = arm.forward(q + h * Values::Unit(i));
      Rate rate;
      rate << (b.position - a.position) / (2 * h),
          rotation_vector<double>(b.orientation * a.orientation.conjugate()) / (2 * h);
      EXPECT_LT((rate - jacobian.col(i)).norm(), 1e-7);
    }
  }
}

}  // namespace
}  // namespace motor_paths
