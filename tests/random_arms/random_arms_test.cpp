// SPDX-License-Identifier: MIT
// What `check` accepts is generated: random arms in every notation, against the independent reference.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "canonical/right_angles.h"
#include "dag/evaluate.h"
#include "derive/inverse/inverse.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "description/reader.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "leaves.h"
#include "model/followers.h"
#include "optimise/described.h"
#include "optimise/dynamics.h"
#include "optimise/optimise.h"
#include "pipeline/pipeline.h"
#include "random_description.h"
#include "reference/dynamics.h"
#include "reference/load.h"
#include "verify/inverse/certify.h"
#include "verify/same_pose.h"

namespace qvgen {
namespace {

using test::Leaves;
using test::symbols;

struct Case {
  std::string text;
  model::Robot robot;
  reference::Chain chain;
};

std::optional<Case> read(const std::string& text) {
  description::ReadResult result = description::read_text(text, "arm.toml");
  if (!result.robot) return std::nullopt;
  return Case{text, *result.robot, reference::load_text(text, symbols())};
}

Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& random) {
  std::uniform_real_distribution<double> between(-3, 3);
  Eigen::VectorXd result(size);
  for (Eigen::Index i = 0; i < size; ++i) result[i] = between(random);
  return result;
}

Leaves leaves_at(const Case& arm, const Eigen::VectorXd& q) {
  Leaves leaves{symbols()};
  const std::vector<std::string> variables = model::variables(arm.robot);
  for (std::size_t i = 0; i < variables.size(); ++i)
    leaves.values[variables[i]] = q[static_cast<Eigen::Index>(i)];
  return leaves;
}

/// Little search: whether a result is right does not depend on how far it is simplified.
optimise::OptimiseOptions quick() {
  optimise::OptimiseOptions options;
  options.search.iterations = 500;
  options.search.restarts = 1;
  options.search.closure = false;
  options.also_fewest = false;
  options.simplify_forms = false;
  options.certificate_points = 1;
  return options;
}

void check_kinematics(const Case& arm, std::mt19937& random) {
  const canonical::Arm canonical = canonical::whatever_notation(arm.robot);
  verify::certify_same_pose(arm.robot, canonical);
  const auto transform = optimise::in_terms_of_description(
      optimise::optimise(derive::homogeneous_transform(canonical.robot), quick()), canonical);
  const auto jacobian = optimise::in_terms_of_description(
      optimise::optimise(derive::jacobian(canonical.robot), quick()), canonical);
  for (int k = 0; k < 3; ++k) {
    const Eigen::VectorXd q = random_vector(arm.chain.size(), random);
    const Leaves leaves = leaves_at(arm, q);
    const auto values = dag::evaluate<double>(transform.function, leaves);
    const Eigen::Isometry3d expected = reference::forward_kinematics(arm.chain, q);
    const double size = 1 + expected.translation().norm();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        ASSERT_NEAR(values[static_cast<std::size_t>(3 * i + j)], expected(i, j), 1e-12) << arm.text;
      ASSERT_NEAR(values[static_cast<std::size_t>(9 + i)], expected(i, 3), 1e-12 * size) << arm.text;
    }
    const Eigen::MatrixXd columns = reference::jacobian(arm.chain, q);
    const auto entries = dag::evaluate<double>(jacobian.function, leaves);
    ASSERT_EQ(entries.size(), static_cast<std::size_t>(columns.size()));
    for (Eigen::Index i = 0; i < columns.rows(); ++i)
      for (Eigen::Index j = 0; j < columns.cols(); ++j)
        ASSERT_NEAR(entries[static_cast<std::size_t>(i * columns.cols() + j)], columns(i, j), 1e-11 * size)
            << arm.text;
  }
}

/// True if inverse kinematics was derived; it is certified in sixty digits.
bool check_inverse(const Case& arm) {
  const auto derivation = derive::inverse::derive(arm.robot);
  if (derivation.found) verify::certify_inverse(derivation.problem, lower(derivation.plan), 1);
  return derivation.found;
}

void check_dynamics(const Case& arm, std::mt19937& random) {
  const model::Robot robot = canonical::for_dynamics(arm.robot);
  optimise::DynamicsEffort effort;
  effort.trial_steps = effort.final_steps = 500;
  effort.certificate_points = 1;
  effort.choices.emplace();
  const auto& quantities = optimise::dynamics_quantities();
  const auto quantity = std::find_if(quantities.begin(), quantities.end(),
                                     [](const auto& each) { return each.name == "inverse_dynamics"; });
  const auto function =
      optimise::generate_dynamics(optimise::dynamics_model(robot, effort), *quantity, effort);
  const dag::Function set_up = optimise::with_definitions(function.constants, robot);
  const Eigen::VectorXd q = random_vector(arm.chain.size(), random);
  const Eigen::VectorXd qd = random_vector(arm.chain.size(), random);
  const Eigen::VectorXd qdd = random_vector(arm.chain.size(), random);
  Leaves leaves = leaves_at(arm, q);
  leaves.values[derive::dynamics::gravity_symbol] = 9.81;
  const auto constants = dag::evaluate<double>(set_up, leaves);
  for (std::size_t i = 0; i < constants.size(); ++i) leaves.values[set_up.outputs[i].name] = constants[i];
  const std::vector<std::string> variables = model::variables(robot);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& variable = variables[i];
    leaves.values[derive::dynamics::velocity_of(variable)] = qd[static_cast<Eigen::Index>(i)];
    leaves.values[derive::dynamics::acceleration_of(variable)] = qdd[static_cast<Eigen::Index>(i)];
    leaves.values[derive::dynamics::direction_of(variable)] = qd[static_cast<Eigen::Index>(i)] < 0 ? -1 : 1;
  }
  const auto torque = dag::evaluate<double>(optimise::in_terms_of_leaders(function.function, robot), leaves);
  const Eigen::VectorXd expected = reference::inverse_dynamics(arm.chain, q, qd, qdd);
  ASSERT_EQ(torque.size(), static_cast<std::size_t>(expected.size()));
  const double size = 1 + expected.norm();
  for (std::size_t i = 0; i < torque.size(); ++i)
    ASSERT_NEAR(torque[i], expected[static_cast<Eigen::Index>(i)], 1e-10 * size) << arm.text;
}

/// QVGEN_RANDOM_ARMS arms, 24 without it; 3000 in long runs.
std::uint32_t count() {
  const char* wanted = std::getenv("QVGEN_RANDOM_ARMS");
  return wanted == nullptr ? 24 : static_cast<std::uint32_t>(std::atoi(wanted));
}

/// So many of kinds that are seldom refused.
std::uint32_t fewer() { return std::max(count() / 8, 8U); }

class RandomArms : public testing::Test {
 protected:
  /// Runs over the random arms, from `first` on; most of them must be accepted, or the law says nothing.
  template <class Check>
  void each(std::uint32_t every, const Check& check, std::uint32_t first = 0) {
    int accepted = 0;
    int tried = 0;
    std::vector<double> times;
    for (std::uint32_t seed = first; seed < count(); seed += every) {
      const bool heavy = every > 1;
      const auto arm =
          read(heavy ? test::random_description_with_inertia(seed) : test::random_description(seed));
      ++tried;
      if (!arm) continue;
      ++accepted;
      std::mt19937 random(seed);
      const auto start = std::chrono::steady_clock::now();
      try {
        check(*arm, random);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        times.push_back(seconds);
        if (seconds > slow_)
          std::printf("arm %u: %zu joints, %.1f s\n", seed, arm->robot.joints.size(), seconds);
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << arm->text;
      }
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(accepted, tried / 2);
    RecordProperty("accepted", accepted);
    std::sort(times.begin(), times.end());
    if (!times.empty())
      std::printf("%zu arms: median %.2f s, longest %.2f s\n", times.size(), times[times.size() / 2],
                  times.back());
  }

 private:
  static constexpr double slow_ = 2;  ///< seconds, beyond which an arm is named
};

TEST_F(RandomArms, KinematicsAndJacobianEqualTheReference) {
  each(1, [](const Case& arm, std::mt19937& random) { check_kinematics(arm, random); });
}

TEST_F(RandomArms, InverseKinematicsIsCertifiedOrRefused) {
  int found = 0;
  each(3, [&](const Case& arm, std::mt19937&) { found += check_inverse(arm) ? 1 : 0; });
  EXPECT_GT(found, 0);
}

TEST_F(RandomArms, DynamicsEqualTheReference) {
  each(3, [](const Case& arm, std::mt19937& random) { check_dynamics(arm, random); });
}

/// Chains in which joints follow others: everything in the values of the rest.
TEST(Followers, KinematicsAndDynamicsEqualTheReference) {
  int followers = 0;
  for (std::uint32_t seed = 0; seed < fewer(); ++seed) {
    const auto arm = read(test::random_description_with_followers(seed));
    if (!arm) continue;
    ASSERT_LT(arm->chain.size(), static_cast<Eigen::Index>(arm->robot.joints.size()));
    ++followers;
    std::mt19937 random(seed);
    check_kinematics(*arm, random);
    check_dynamics(*arm, random);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(followers, static_cast<int>(fewer() / 2));
}

/// Chains in which joints follow motors: the arm without, composed with the matrix.
TEST(Motors, KinematicsAndDynamicsEqualTheReference) {
  int accepted = 0, with_motors = 0;
  for (std::uint32_t seed = 0; seed < fewer(); ++seed) {
    const std::string text = test::random_description_with_motors(seed);
    const auto arm = read(text);
    if (!arm) continue;
    ++accepted;
    with_motors += arm->robot.motors.empty() ? 0 : 1;
    ASSERT_EQ(arm->chain.driven(), model::variables(arm->robot)) << text;
    std::mt19937 random(seed);
    check_kinematics(*arm, random);
    check_dynamics(*arm, random);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(accepted, static_cast<int>(fewer() / 2));
  EXPECT_GT(with_motors, accepted / 2);
}

TEST_F(RandomArms, AJointThatMovesNoMassCostsForwardDynamicsAlone) {
  const auto arm = read(R"toml(name = "light_hand"
title = "the second link has no mass"
[[joint]]
type = "revolute"
axis = "+z"
variable = "theta1"
mass = 2.5
centre_of_mass = [0.1, 0, 0]
inertia = [0.02, 0.03, 0.025]
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta2"
link = [0.3, 0, 0]
)toml");
  ASSERT_TRUE(arm);
  const pipeline::RobotOutput output = pipeline::generate({arm->robot}, {"dynamics"}).front();
  EXPECT_TRUE(output.counts.contains("inverse_dynamics"));
  EXPECT_FALSE(output.counts.contains("forward_dynamics"));
  ASSERT_FALSE(output.missing.empty());
  EXPECT_EQ(output.missing.front().part, "forward_dynamics");
  EXPECT_EQ(output.missing.front().kind, pipeline::Missing::Kind::not_derived);
  EXPECT_EQ(output.missing.front().reason, "joint 2 moves no mass: the mass matrix has no inverse");
}

/// All files, with the effort of a real run. Only what no derivation covers may be missing, and no part may
/// take more than 20 s of processor time or 1 GB. A usual run has one arm, of four joints: each joint more
/// takes twice as long.
TEST_F(RandomArms, EverythingIsGenerated) {
  const auto check = [](const Case& arm, std::mt19937&) {
    const pipeline::RobotOutput output = pipeline::generate({arm.robot}, {}, {20, 1024}).front();
    for (const char* part : {"model", "kinematics", "jacobian", "dynamics"})
      EXPECT_TRUE(pipeline::has_part(output.missing, part)) << part << "\n" << arm.text;
    for (const pipeline::Missing& missing : output.missing) {
      EXPECT_NE(missing.kind, pipeline::Missing::Kind::refuted) << missing.part << ": " << missing.reason;
      EXPECT_NE(missing.kind, pipeline::Missing::Kind::not_finished)
          << missing.part << ": " << missing.reason;
    }
  };
  each(75, check, count() > 75 ? 0 : 4);
}

}  // namespace
}  // namespace qvgen
