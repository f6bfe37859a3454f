// SPDX-License-Identifier: MIT
// Exact data give the true parameters, and as many as an independent rank says; noise gives the deviations
// that are promised.
#include "identify/estimate.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "random_arm.h"
#include "reference/linear_algebra.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using identify::ArmRegressor;
using identify::Estimate;
using identify::MotionLog;

/// Every second kind of arm in usual runs, all if QVGEN_TRIALS asks for long ones.
std::vector<std::string> some_of(const std::vector<std::string>& all) {
  const std::size_t step = std::getenv("QVGEN_TRIALS") == nullptr ? 2 : 1;
  std::vector<std::string> some;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}
const std::vector<std::string> kinds =
    some_of({"RRRRRR", "RRR", "RPR", "RRRRRRR", "PRRR", "PPR", "R", "RRPR"});

/// Forces on what the caller moves, a row each, by unit forces of the drives of joints, then of motors.
MatrixXd forces_of_drives(const reference::Chain& chain) {
  const auto links = static_cast<Index>(chain.joints.size()),
             motors = static_cast<Index>(chain.motors.size());
  MatrixXd forces = MatrixXd::Zero(chain.size(), links + motors);
  forces.leftCols(links) = chain.coupling().transpose();
  const std::vector<std::string> names = chain.driven();
  for (Index i = 0; i < motors; ++i)
    for (Index row = 0; row < chain.size(); ++row)
      if (names[static_cast<std::size_t>(row)] == chain.motors[static_cast<std::size_t>(i)].variable)
        forces(row, links + i) = 1;
  return forces;
}

/// Columns of the tests' own dynamics by unit parameters of links and drives, offsets included.
MatrixXd reference_regressor(const reference::Chain& chain, const MotionLog& log) {
  const auto links = static_cast<Index>(chain.joints.size());
  const VectorXd truth = parameters_of(chain);
  const auto torque = [&](const reference::Chain& arm) {
    VectorXd all(log.samples() * log.joints());
    for (Index k = 0; k < log.samples(); ++k)
      all.segment(k * log.joints(), log.joints()) = reference::inverse_dynamics(
          arm, log.q.row(k).transpose(), log.qd.row(k).transpose(), log.qdd.row(k).transpose(), gravity);
    return all;
  };
  MatrixXd columns(log.samples() * log.joints(), truth.size());
  for (Index k = 0; k < columns.cols(); ++k)
    columns.col(k) =
        torque(with_parameters(chain, truth + VectorXd::Unit(columns.cols(), k))) - torque(chain);
  const MatrixXd forces = forces_of_drives(chain);
  for (Index unit = 0; unit < forces.cols(); ++unit)  // the reference knows no offsets
    for (Index row = 0; row < columns.rows(); ++row)
      columns(row, 10 * links + 4 * unit + 3) = forces(row % log.joints(), unit);
  for (Index i = 0; i < links; ++i)  // no description has this, by the direction of a sum
    if (chain.joints[static_cast<std::size_t>(i)].leaders.size() > 1)
      columns.col(10 * links + 4 * i + 2).setZero();
  return columns;
}

Index rank_of(const MatrixXd& columns) {
  MatrixXd scaled = columns;
  for (Index k = 0; k < scaled.cols(); ++k)
    if (const double length = scaled.col(k).norm(); length > 1e-12) scaled.col(k) /= length;
  const VectorXd values = reference::spectrum(scaled);
  return (values.array() > 1e-9 * values[0]).count();
}

TEST(Estimate, ExactDataGiveTheTrueParameters) {
  unsigned seed = 1;
  for (const std::string& kind : kinds) {
    const std::string text = ArmWriter(seed++).text(kind);
    const reference::Chain chain = reference::load_text(text);
    const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
    const VectorXd truth = arm.combination * parameters_of(chain);
    const Estimate found = estimate(equations_of(arm, simulated(chain, 2000, seed)), arm.parameters());
    EXPECT_LT((found.value - truth).cwiseAbs().maxCoeff(), 1e-9 * std::max(1.0, truth.norm())) << text;
    for (const bool told : found.told) EXPECT_TRUE(told) << text;
  }
}

TEST(Estimate, ThereAreAsManyParametersAsAnIndependentRankSays) {
  unsigned seed = 30;
  for (const std::string& kind : kinds) {
    const std::string text = ArmWriter(seed++).text(kind);
    const reference::Chain chain = reference::load_text(text);
    const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
    EXPECT_EQ(arm.parameters(), rank_of(reference_regressor(chain, simulated(chain, 120, seed, 30)))) << text;
  }
}

/// Logs of motors tell as many parameters as an independent rank says. A column that depends on others by
/// lengths or angles stays among the names; it is not told, and its parameter is part of the others.
TEST(Estimate, ExactLogsOfMotorsGiveTheTrueParameters) {
  unsigned seed = 80;
  for (const std::string& kind : some_of({"RRRRRR", "RRR", "RRPR", "RPR", "PRRR", "RR", "RRRR"})) {
    const std::string text = ArmWriter(seed++).with_motors(kind);
    const reference::Chain chain = reference::load_text(text);
    const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
    const VectorXd truth = arm.combination * parameters_of(chain);
    const Estimate found = estimate(equations_of(arm, simulated(chain, 2000, seed)), arm.parameters());
    EXPECT_EQ(std::count(found.told.begin(), found.told.end(), true),
              rank_of(reference_regressor(chain, simulated(chain, 120, seed, 30))))
        << text;
    for (Index k = 0; k < truth.size(); ++k)
      if (found.told[static_cast<std::size_t>(k)]) {
        EXPECT_NEAR(found.value[k], truth[k] + found.parts.col(k).dot(truth),
                    1e-9 * std::max(1.0, truth.norm()))
            << arm.names[static_cast<std::size_t>(k)] << text;
      }
  }
}

TEST(Estimate, DrivesThatAreLeftOutHaveNoParameters) {
  const model::Robot robot = read_arm(ArmWriter(3).text("RRR"));
  const auto all = identify::arm_regressor(robot, identify::all_drives());
  const auto none = identify::arm_regressor(robot, {});
  const auto viscous = identify::arm_regressor(robot, {identify::DriveParameter::viscous_friction});
  EXPECT_EQ(viscous.parameters(), none.parameters() + 3);
  EXPECT_GT(all.parameters(), viscous.parameters());
  for (const std::string& name : none.names)
    EXPECT_FALSE(name.starts_with("f") || name.starts_with("off")) << name;
}

/// Joint 2 stands still: nothing that needs its motion is told, and what is told is right.
TEST(Estimate, WhatDataDoNotTellIsNamed) {
  const std::string text = ArmWriter(9).text("RRR");
  const reference::Chain chain = reference::load_text(text);
  MotionLog log = simulated(chain, 1000, 4);
  log.q.col(1).setConstant(0.4);
  log.qd.col(1).setZero();
  log.qdd.col(1).setZero();
  fill_torques(chain, log);
  const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
  const Estimate found = estimate(equations_of(arm, log), arm.parameters());
  EXPECT_EQ(std::count(found.told.begin(), found.told.end(), true), rank_of(reference_regressor(chain, log)));
  const VectorXd truth = arm.combination * parameters_of(chain);
  for (Index k = 0; k < truth.size(); ++k) {
    if (found.told[static_cast<std::size_t>(k)]) {
      EXPECT_NEAR(found.value[k], truth[k] + found.parts.col(k).dot(truth), 1e-7);
    } else if (arm.names[static_cast<std::size_t>(k)] == "fv2") {
      EXPECT_TRUE(found.parts.row(k).isZero(0));
    }
  }
}

TEST(Estimate, TooFewRowsAreRefused) {
  const std::string text = ArmWriter(2).text("RR");
  const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
  EXPECT_THROW(estimate(equations_of(arm, simulated(reference::load_text(text), 8, 1)), arm.parameters()),
               std::runtime_error);
}

TEST(Estimate, RowsThatAreNotFiniteAreLeftOut) {
  const std::string text = ArmWriter(5).text("RR");
  const reference::Chain chain = reference::load_text(text);
  const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
  MotionLog log = simulated(chain, 1000, 1);
  log.torque(17, 0) = log.qdd(300, 1) = std::nan("");
  const Estimate found = estimate(equations_of(arm, log), arm.parameters());
  EXPECT_EQ(found.measured, (std::vector<Index>{998, 999}));
  const VectorXd truth = arm.combination * parameters_of(chain);
  EXPECT_LT((found.value - truth).norm(), 1e-9 * truth.norm());
}

/// Two logs together are one long log.
TEST(Estimate, LogsAreJoined) {
  const std::string text = ArmWriter(6).text("RRR");
  const reference::Chain chain = reference::load_text(text);
  const ArmRegressor arm = identify::arm_regressor(read_arm(text), identify::all_drives());
  MotionLog first = simulated(chain, 700, 1), second = simulated(chain, 900, 2);
  add_noise(first, VectorXd::Constant(3, 0.1), 1);
  add_noise(second, VectorXd::Constant(3, 0.1), 2);
  MotionLog both = first;
  const auto append = [](MatrixXd& to, const MatrixXd& more) {
    MatrixXd all(to.rows() + more.rows(), to.cols());
    all << to, more;
    to = all;
  };
  append(both.q, second.q);
  append(both.qd, second.qd);
  append(both.qdd, second.qdd);
  append(both.torque, second.torque);
  auto joined = equations_of(arm, first);
  add(joined, equations_of(arm, second));
  const Estimate a = estimate(joined, arm.parameters()),
                 b = estimate(equations_of(arm, both), arm.parameters());
  EXPECT_LT((a.value - b.value).norm(), 1e-9 * b.value.norm());
  EXPECT_LT((a.deviation - b.deviation).norm(), 1e-9 * b.deviation.norm());
}

/// 200 repetitions with noise of different size for each joint.
class Repetitions : public testing::Test {
 protected:
  static constexpr int count = 200;
  static void SetUpTestSuite() {
    const std::string text = ArmWriter(12).text("RRR");
    const reference::Chain chain = reference::load_text(text);
    arm = std::make_unique<ArmRegressor>(identify::arm_regressor(read_arm(text), identify::all_drives()));
    truth = arm->combination * parameters_of(chain);
    const MotionLog log = simulated(chain, 1000, 3);
    for (int trial = 0; trial < count; ++trial) {
      MotionLog noisy = log;
      add_noise(noisy, deviations, static_cast<unsigned>(trial + 1));
      found.push_back(estimate(equations_of(*arm, noisy), arm->parameters()));
    }
  }
  static inline const VectorXd deviations = Eigen::Vector3d(2, 0.5, 0.05);
  static inline std::unique_ptr<ArmRegressor> arm;
  static inline VectorXd truth;
  static inline std::vector<Estimate> found;
};

TEST_F(Repetitions, CovarianceIsTheSpread) {
  const Index n = truth.size();
  MatrixXd spread = MatrixXd::Zero(n, n), promised = MatrixXd::Zero(n, n);
  double distances = 0;
  for (const Estimate& each : found) {
    const VectorXd error = each.value - truth;
    spread += error * error.transpose() / count;
    promised += each.covariance / count;
    distances += error.dot(reference::solve_symmetric(each.covariance, error)) / count;
  }
  for (Index k = 0; k < n; ++k)  // a deviation from 200 trials is good to 5 percent
    EXPECT_NEAR(std::sqrt(spread(k, k) / promised(k, k)), 1, 0.2) << arm->names[static_cast<std::size_t>(k)];
  const auto parameters = static_cast<double>(n);  // chi squared: mean n, deviation sqrt(2 n) each
  EXPECT_NEAR(distances, parameters, 5 * std::sqrt(2 * parameters / count));
}

TEST_F(Repetitions, ParametersAreWithinThreeDeviations) {
  Index inside = 0;
  for (const Estimate& each : found)
    inside += ((each.value - truth).cwiseAbs().array() <= 3 * each.deviation.array()).count();
  EXPECT_GE(static_cast<double>(inside), 0.99 * count * static_cast<double>(truth.size()));
}

TEST_F(Repetitions, ResidualsAreAtTheNoise) {
  VectorXd mean = VectorXd::Zero(3);
  for (const Estimate& each : found) mean += each.noise / count;
  for (Index i = 0; i < 3; ++i) EXPECT_NEAR(mean[i] / deviations[i], 1, 0.01);
}

}  // namespace
}  // namespace qvgen::test
