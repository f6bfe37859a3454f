// SPDX-License-Identifier: MIT
// Planned motions keep their limits, begin and end at rest, and tell all parameters; payloads come out of two
// logs.
#include "identify/plan.h"

#include <gtest/gtest.h>

#include "identify/identification.h"
#include "random_arm.h"
#include "simulated.h"

namespace qvgen::test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::MotionLog;

const std::string limits = "limits = [-1.2, 0.8]\nvelocity_limit = 0.9\n";

std::string limited(std::string text) {
  for (std::size_t at = 0; (at = text.find("origin", at)) != std::string::npos; at += limits.size() + 6)
    text.insert(at, limits);
  return text;
}

TEST(Plan, KeepsLimitsAndTellsAll) {
  const std::string text = limited(ArmWriter(3).text("RRR"));
  identify::PlanRequest request;
  request.trials = 30;
  request.rate = 1000;
  const identify::Plan plan = identify::plan(read_arm(text), request);
  const MotionLog& motion = plan.motion;
  EXPECT_EQ(motion.samples(), 20001);
  EXPECT_LE(motion.q.maxCoeff(), 0.8);
  EXPECT_GE(motion.q.minCoeff(), -1.2);
  EXPECT_LE(motion.qd.cwiseAbs().maxCoeff(), 0.9);
  for (const Index row : {Index(0), motion.samples() - 1}) {
    EXPECT_TRUE(motion.qd.row(row).isZero(1e-12));
    EXPECT_TRUE(motion.qdd.row(row).isZero(1e-9));
  }
  for (Index k = 1; k + 1 < motion.samples(); ++k)  // rates and accelerations are derivatives
    for (Index i = 0; i < 3; ++i) {
      EXPECT_NEAR(motion.qd(k, i), (motion.q(k + 1, i) - motion.q(k - 1, i)) * 500, 1e-2);
      EXPECT_NEAR(motion.qdd(k, i), (motion.qd(k + 1, i) - motion.qd(k - 1, i)) * 500, 1e-2);
    }
  EXPECT_GT(plan.deviation.minCoeff(), 0);  // all are told
  EXPECT_LT(plan.condition, 1000);
  EXPECT_EQ(identify::plan(read_arm(text), request).motion.q, motion.q);  // the same again
}

/// Joints that several motors move keep limits of their own, wherever the middle of the motors' ranges is.
TEST(Plan, OfMotorsKeepsTheJointsLimits) {
  const std::string own = "follows = ", at = "limits = [0.4, 1.9]\n";
  for (unsigned seed = 40; seed < 44; ++seed) {
    std::string text = ArmWriter(seed).with_motors("RRRR");
    for (std::size_t i = 0; (i = text.find(own, i)) != std::string::npos; i += at.size() + own.size())
      text.insert(i, at);
    identify::PlanRequest request;
    request.trials = 6;
    const identify::Plan plan = identify::plan(read_arm(text), request);
    const reference::Chain chain = reference::load_text(text);
    Eigen::MatrixXd joints = chain.coupling() * plan.motion.q.transpose();
    for (Index i = 0; i < joints.rows(); ++i) {
      const reference::Joint& joint = chain.joints[static_cast<std::size_t>(i)];
      if (joint.leaders.empty()) continue;
      EXPECT_LE(joints.row(i).maxCoeff() + joint.offset, 1.9) << text;
      EXPECT_GE(joints.row(i).minCoeff() + joint.offset, 0.4) << text;
    }
    EXPECT_GT(plan.deviation.minCoeff(), 0) << text;
  }
}

/// The greatest share of a limit of torque, by the tests' own dynamics.
double effort_of(const std::string& text, MotionLog motion, const VectorXd& limits) {
  fill_torques(reference::load_text(text), motion);
  return (motion.torque.cwiseAbs().colwise().maxCoeff().transpose().array() / limits.array()).maxCoeff();
}

std::string with_efforts(std::string text, const VectorXd& limits) {
  std::size_t at = 0;
  for (const double limit : limits) {
    const std::string line = "effort_limit = " + std::to_string(limit) + "\n";
    at = text.find("origin", at);
    text.insert(at, line);
    at += line.size() + 6;
  }
  return text;
}

TEST(Plan, KeepsLimitsOfTorque) {
  const std::string text = limited(ArmWriter(3).text("RRR"));
  identify::PlanRequest request;
  request.trials = 30;
  const identify::Plan free = identify::plan(read_arm(text), request);
  EXPECT_FALSE(free.effort);
  // Four fifths of what the motion needs that knows no limits; all of it is 1 / 0.8.
  MotionLog motion = free.motion;
  fill_torques(reference::load_text(text), motion);
  const VectorXd limits = motion.torque.cwiseAbs().colwise().maxCoeff().transpose();
  const std::string tight = with_efforts(text, limits);
  EXPECT_NEAR(effort_of(text, free.motion, limits), 1, 1e-12);
  const identify::Plan plan = identify::plan(read_arm(tight), request);
  ASSERT_TRUE(plan.effort);
  EXPECT_LE(*plan.effort, 0.8);
  EXPECT_NEAR(effort_of(text, plan.motion, limits), *plan.effort, 1e-5);
  EXPECT_GT(*plan.effort, 0.6) << "smaller than it has to be";
  EXPECT_GT(plan.deviation.minCoeff(), 0);
  for (Index k = 1; k + 1 < plan.motion.samples(); ++k)
    for (Index i = 0; i < 3; ++i)
      EXPECT_NEAR(plan.motion.qd(k, i), (plan.motion.q(k + 1, i) - plan.motion.q(k - 1, i)) * 50, 0.1);
  EXPECT_THROW(identify::plan(read_arm(with_efforts(text, limits / 100)), request), std::runtime_error);
  EXPECT_FALSE(identify::plan(read_arm(without_inertia(tight)), request).effort);
}

TEST(Plan, SlidesNeedLimits) {
  EXPECT_THROW(identify::plan(read_arm(ArmWriter(3).text("PR")), {}), std::runtime_error);
}

TEST(Payload, IsTheDifferenceOfTwoLogs) {
  const std::string text = ArmWriter(14).text("RRRRRR");
  const reference::Chain chain = reference::load_text(text);
  VectorXd loaded = parameters_of(chain);
  const double mass = 2.5;
  const Eigen::Vector3d c(0.05, -0.02, 0.1);
  Eigen::Matrix3d inertia;
  inertia << 0.02, 0.001, -0.002, 0.001, 0.025, 0.003, -0.002, 0.003, 0.015;
  const Eigen::Matrix3d origin =
      inertia + mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  VectorXd payload(10);
  payload << mass, mass * c, origin(0, 0), origin(1, 1), origin(2, 2), origin(0, 1), origin(1, 2),
      origin(0, 2);
  loaded.segment(50, 10) += payload;
  const MotionLog empty = simulated(chain, 2000, 1);
  const MotionLog with = simulated(with_parameters(chain, loaded), 2000, 2);
  const auto found = identify::identify(read_arm(text), {empty}, {}, {}, {with}).payload;
  ASSERT_TRUE(found);
  for (const bool told : found->told) EXPECT_TRUE(told);
  EXPECT_NEAR(found->body.mass, mass, 1e-8);
  EXPECT_LT((found->body.centre - c).norm(), 1e-8);
  const double expected[6] = {0.02, 0.025, 0.015, 0.001, 0.003, -0.002};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found->body.inertia[k], expected[k], 1e-8);
}

}  // namespace
}  // namespace qvgen::test
