// SPDX-License-Identifier: MIT
// What is proven of rows that the elimination finds, and that nothing wrong is.
#include "../elimination/arms.h"

#include <chrono>
#include <cstdio>

#include <gtest/gtest.h>
#include <qvgen/inverse/certified/certify.h>

namespace qvgen::test {
namespace {

namespace certified = inverse::certified;
using Row = std::array<double, certified::joints>;

/// The arm whose numbers are next to those doubles.
certified::Arm in_bounds(const Arm& arm) {
  const inverse::elimination::Description description = arm.description();
  certified::Arm result;
  for (std::size_t i = 0; i < certified::joints; ++i) {
    const inverse::Screw<double>& joint = description.axes[i];
    result.joints[i].revolute = joint.revolute;
    for (std::size_t k = 0; k < 3; ++k) {
      result.joints[i].axis[k] = certified::next_to(joint.axis[k]);
      result.joints[i].point[k] = certified::next_to(joint.point[k]);
    }
  }
  const Eigen::Isometry3d tool = arm.tool(Joints6::Zero());
  const Eigen::Quaterniond turn(tool.rotation());
  const std::array<double, 4> numbers{turn.w(), turn.x(), turn.y(), turn.z()};
  for (std::size_t k = 0; k < 4; ++k) result.turn[k] = numbers[k];
  for (std::size_t k = 0; k < 3; ++k) result.place[k] = tool.translation()[static_cast<Eigen::Index>(k)];
  return result;
}

struct Outcome {
  certified::Count count;
  std::vector<RowProof> proofs;
};

Outcome certify(const certified::Arm& arm, const Pose<double>& pose, const std::vector<Row>& rows,
                const certified::Effort& effort = {}) {
  Outcome outcome;
  outcome.proofs.resize(rows.size() + 1);
  const auto* first = reinterpret_cast<const double(*)[certified::joints]>(rows.data());
  outcome.count =
      certified::certify(arm, pose, first, static_cast<int>(rows.size()), effort, outcome.proofs.data());
  outcome.proofs.resize(rows.size());
  return outcome;
}

/// An arm and a pose that it reaches, with the rows that are found for it.
struct Case {
  explicit Case(const Arm& from)
      : arm(from), bounds(in_bounds(from)), setup(inverse::elimination::set_up(from.description())) {}

  void take(const Joints6& q) {
    const Eigen::Isometry3d tool = arm.tool(q);
    pose = Pose<double>::from_matrix(tool.rotation(), tool.translation());
    rows.clear();
    for (const auto& row : solve(setup, pose)) {
      rows.emplace_back();
      std::copy(row.q.data(), row.q.data() + certified::joints, rows.back().begin());
    }
  }

  const Arm& arm;
  certified::Arm bounds;
  inverse::elimination::Setup setup;
  Pose<double> pose;
  std::vector<Row> rows;
};

std::vector<Arm> arms() {
  std::vector<Arm> all = named_arms();
  for (unsigned seed = 1; seed <= 6; ++seed)
    all.push_back(random_arm(seed, seed <= 3 ? 0 : seed <= 5 ? 1 : 2));
  return all;
}

int poses() {
  const char* wanted = std::getenv("QVGEN_POSES");
  return wanted != nullptr ? std::atoi(wanted) : 3;
}

bool is_complete(const Outcome& outcome) { return outcome.count.proof == Proof::complete; }

/// All that the elimination finds is proven to be all that there is, of random poses, unless two solutions
/// nearly meet.
TEST(CertifiedArms, RandomPosesAreComplete) {
  Random random(1);
  std::printf("%-24s %9s %9s %9s %9s\n", "arm", "rows", "complete", "boxes", "ms");
  for (const Arm& arm : arms()) {
    Case it(arm);
    int complete = 0;
    double rows = 0, boxes = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < poses(); ++n) {
      it.take(arm.joints(random));
      const Outcome outcome = certify(it.bounds, it.pose, it.rows);
      complete += is_complete(outcome) ? 1 : 0;
      rows += static_cast<double>(it.rows.size());
      boxes += outcome.count.boxes;
      for (const RowProof& proof : outcome.proofs) {
        if (!is_complete(outcome)) continue;
        EXPECT_TRUE(proof.proven);
        EXPECT_LT(proof.within, 1e-8);
        EXPECT_GT(proof.alone_within, proof.within);
      }
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::printf("%-24s %9.2f %8.1f%% %9.0f %9.1f\n", arm.name.c_str(), rows / poses(),
                100.0 * complete / poses(), boxes / poses(), time.count() / poses());
    EXPECT_GE(complete, poses() - 1 - poses() / 50) << arm.name;
  }
}

TEST(CertifiedArms, ALackingRowIsNeverComplete) {
  Random random(2);
  certified::Effort effort;
  effort.boxes = 20000;
  for (const Arm& arm : arms()) {
    Case it(arm);
    it.take(arm.joints(random));
    if (!is_complete(certify(it.bounds, it.pose, it.rows, effort))) continue;
    for (std::size_t lacks = 0; lacks < it.rows.size(); ++lacks) {
      std::vector<Row> others = it.rows;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(lacks));
      EXPECT_FALSE(is_complete(certify(it.bounds, it.pose, others, effort))) << arm.name << ' ' << lacks;
    }
  }
}

TEST(CertifiedArms, ARowThatIsWrongOrThereTwiceIsNotProven) {
  Random random(3);
  for (const Arm& arm : arms()) {
    Case it(arm);
    it.take(arm.joints(random));
    if (!is_complete(certify(it.bounds, it.pose, it.rows))) continue;
    std::vector<Row> rows = it.rows;
    rows.front()[4] += 1e-6;
    const Outcome moved = certify(it.bounds, it.pose, rows);
    EXPECT_FALSE(moved.proofs.front().proven) << arm.name;
    EXPECT_FALSE(is_complete(moved)) << arm.name;
    rows = it.rows;
    rows.push_back(rows.front());
    EXPECT_FALSE(is_complete(certify(it.bounds, it.pose, rows))) << arm.name;
    // A whole turn further it is the same solution.
    if (!arm.slides[2]) rows.back()[2] += 2 * std::acos(-1.0);
    const Outcome turned = certify(it.bounds, it.pose, rows);
    EXPECT_TRUE(turned.proofs.back().proven) << arm.name;
    EXPECT_FALSE(is_complete(turned)) << arm.name;
  }
}

/// The solution that a row's proof speaks of is that of a pose which is off by a little: the distance grows.
TEST(CertifiedArms, DistancesHoldTheSolution) {
  Random random(4);
  const Arm arm = crx10ia();
  Case it(arm);
  for (int n = 0; n < 20; ++n) {
    const Joints6 q = arm.joints(random);
    it.take(q);
    for (std::size_t i = 0; i < it.rows.size(); ++i) {
      Joints6 row;
      std::copy(it.rows[i].begin(), it.rows[i].end(), row.data());
      if (arm.distance(row, q) > 1e-6) continue;
      std::vector<Row> rows = it.rows;
      for (double& value : rows[i]) value += 1e-9;
      const Outcome outcome = certify(it.bounds, it.pose, rows);
      ASSERT_TRUE(outcome.proofs[i].proven);
      EXPECT_GE(outcome.proofs[i].within, 0.99e-9);
      EXPECT_LE(outcome.proofs[i].within, 1.5e-9);
    }
  }
}

TEST(CertifiedArms, OutOfReachHasNoSolution) {
  for (const Arm& arm : arms()) {
    if (arm.slides[0] || arm.name.find("slide") != std::string::npos) continue;
    Case it(arm);
    it.pose = {Eigen::Quaterniond::UnitRandom(), Vector3<double>(100 * arm.size(), 1, 2)};
    EXPECT_TRUE(is_complete(certify(it.bounds, it.pose, {}))) << arm.name;
  }
}

TEST(CertifiedArms, WhatIsNoPoseIsNotProven) {
  const Arm arm = xarm6();
  Case it(arm);
  it.take(Joints6::Constant(0.4));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {nan, infinity, 1e300}) {
    Pose<double> pose = it.pose;
    pose.position.y() = wrong;
    EXPECT_FALSE(is_complete(certify(it.bounds, pose, it.rows)));
    EXPECT_FALSE(is_complete(certify(it.bounds, pose, {})));
    pose = it.pose;
    pose.orientation.w() = wrong;
    EXPECT_FALSE(is_complete(certify(it.bounds, pose, {})));
    std::vector<Row> rows = it.rows;
    rows[0][3] = wrong;
    EXPECT_FALSE(is_complete(certify(it.bounds, it.pose, rows)));
  }
}

TEST(CertifiedArms, EffortIsKeptTo) {
  const Arm arm = jaco2();
  Case it(arm);
  it.take(Joints6::Constant(0.4));
  certified::Effort effort;
  effort.boxes = 10;
  const Outcome outcome = certify(it.bounds, it.pose, it.rows, effort);
  EXPECT_EQ(outcome.count.boxes, 10);
  EXPECT_FALSE(is_complete(outcome));
}

}  // namespace
}  // namespace qvgen::test
