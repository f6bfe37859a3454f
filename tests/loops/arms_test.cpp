// SPDX-License-Identifier: MIT
// Arms and legs with closed loops from poses of their tips: every row reaches the pose with closed loops,
// none that Newton's steps of all joints together find is missing, and motors move the tip as their Jacobian
// says.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "mechanism_under_test.h"
#include "reference/loops.h"

namespace qvgen::test::loops {
namespace {

std::vector<MechanismUnderTest> arms() {
  std::vector<MechanismUnderTest> list;
  for (const MechanismUnderTest& each : mechanisms())
    if (each.tips.front().inverse) list.push_back(each);
  return list;
}

class Arms : public testing::TestWithParam<MechanismUnderTest> {
 protected:
  Arms() {
    for (const reference::NamedFrame& frame : reference_.chain.frames)
      if (frame.name == tip_.name) frame_ = frame;
  }
  VectorXd zero() const { return VectorXd::Zero(mechanism_.dof); }
  /// A random assembly, apart from dead centres. The reference's is closed to twelve digits; from a little
  /// beside it Newton's steps close it to rounding, which a tip that follows few poses needs.
  VectorXd sampled() {
    while (true) {
      const auto found = reference::assemblies(reference_, zero(), {}, 1, static_cast<unsigned>(random_()));
      if (found.empty() || mechanism_.drive_measure(found[0]) < 0.05) continue;
      VectorXd a(mechanism_.driven);
      for (int i = 0; i < mechanism_.driven; ++i)
        a[i] = found[0][mechanism_.driven_joints[static_cast<std::size_t>(i)]];
      const VectorXd q = mechanism_.follow(a, found[0] + VectorXd::Constant(mechanism_.dof, 1e-4));
      if (q.size() > 0) return q;
    }
  }
  Eigen::Matrix4d pose(const VectorXd& q) const {
    return reference::pose_of(reference_.chain, frame_, q).matrix();
  }
  double distance(const VectorXd& a, const VectorXd& b) const {
    double worst = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const bool turns = reference_.chain.joints[static_cast<std::size_t>(i)].revolute;
      worst = std::max(worst, std::abs(turns ? std::remainder(a[i] - b[i], 2 * M_PI) : a[i] - b[i]));
    }
    return worst;
  }
  bool has(const Set& set, const VectorXd& q, double within) const {
    return std::any_of(set.rows.begin(), set.rows.end(),
                       [&](const Row& row) { return distance(row.q, q) < within; });
  }
  void expect_reached(const Set& set, const Eigen::Matrix4d& wanted) const {
    for (const Row& row : set.rows) {
      EXPECT_LT(reference::gaps(reference_, row.q).cwiseAbs().maxCoeff(), 1e-12 * reference_.size);
      EXPECT_LT((pose(row.q) - wanted).norm(), 1e-11);
    }
  }

  const MechanismUnderTest& mechanism_ = GetParam();
  const Tip& tip_ = mechanism_.tips.front();
  const reference::LoopMechanism reference_ = reference::load_loops(mechanism_.description);
  reference::NamedFrame frame_;
  std::mt19937 random_{5};
};

TEST_P(Arms, ReachPosesWithClosedLoopsEachRowOnce) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const VectorXd q = sampled();
    const Set set = tip_.inverse(pose(q));
    EXPECT_TRUE(set.status == Status::solved || set.status == Status::singular);
    EXPECT_TRUE(has(set, q, 1e-6)) << q.transpose();
    expect_reached(set, pose(q));
    for (std::size_t i = 0; i < set.rows.size(); ++i) {
      EXPECT_LT(set.rows[i].branch, tip_.capacity);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NE(set.rows[i].branch, set.rows[j].branch);
        EXPECT_GT(distance(set.rows[i].q, set.rows[j].q), 1e-9);
      }
    }
  }
}

TEST_P(Arms, LackNoRowThatNewtonFindsFromManyStarts) {
  int compared = 0;
  for (int k = 0; k < QVGEN_LOOP_INPUTS / 8; ++k) {
    const VectorXd q = sampled();
    const Set set = tip_.inverse(pose(q));
    const reference::Reached reached{frame_, Eigen::Isometry3d(pose(q))};
    if (set.status != Status::solved) continue;
    for (const VectorXd& other :
         reference::assemblies(reference_, zero(), {}, 60, static_cast<unsigned>(k), reached)) {
      EXPECT_TRUE(has(set, other, 1e-5)) << "missing: " << other.transpose();
      ++compared;
    }
  }
  EXPECT_GT(compared, QVGEN_LOOP_INPUTS / 8);
}

TEST_P(Arms, PutTheSeedsRowFirstByWholeTurns) {
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const VectorXd q = sampled();
    VectorXd seed = q;
    for (Eigen::Index i = 0; i < q.size(); ++i)
      if (reference_.chain.joints[static_cast<std::size_t>(i)].revolute) seed[i] += 2 * M_PI;
    // A motor that a joint follows has turned as often as that has.
    for (const reference::Gear& gear : reference_.gears)
      seed[gear.leaders[0].first] = (seed[gear.joint] - gear.offset) / gear.leaders[0].second;
    const Set set = tip_.inverse_next_to(pose(q), seed);
    ASSERT_FALSE(set.rows.empty());
    EXPECT_LT((set.rows.front().q - seed).norm(), 1e-6);
    const Set near = tip_.inverse_near(pose(q), seed);
    ASSERT_EQ(near.rows.size(), 1U);
    EXPECT_LT((near.rows.front().q - seed).norm(), 1e-6);
    if (near.rows.front().branch >= 0) {
      EXPECT_EQ(near.rows.front().branch, set.rows.front().branch);
    }
  }
}

TEST_P(Arms, KeepToTheLimitsOfAllJoints) {
  int inside = 0;
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const VectorXd q = sampled();
    const Set all = tip_.inverse(pose(q)), within = tip_.within_limits(pose(q));
    const auto is_inside = [&](const VectorXd& row) {
      for (Eigen::Index i = 0; i < row.size(); ++i) {
        const reference::Joint& joint = reference_.chain.joints[static_cast<std::size_t>(i)];
        if (row[i] < joint.lower - 1e-9 || row[i] > joint.upper + 1e-9) return false;
      }
      return true;
    };
    for (const Row& row : within.rows) EXPECT_TRUE(is_inside(row.q)) << row.q.transpose();
    for (const Row& row : all.rows)
      if (is_inside(row.q)) {
        EXPECT_TRUE(has(within, row.q, 1e-9));
        ++inside;
      }
  }
  EXPECT_GT(inside, 0);
}

TEST_P(Arms, SayWhatCannotBeReached) {
  Eigen::Matrix4d far = pose(sampled());
  far(2, 3) += 10 * reference_.size;
  EXPECT_EQ(tip_.inverse(far).status, Status::unreachable);
  EXPECT_EQ(tip_.inverse_near(far, zero()).status, Status::unreachable);
  EXPECT_TRUE(tip_.inverse(far).rows.empty() && tip_.inverse_near(far, zero()).rows.empty());
  Eigen::Matrix4d bad = pose(sampled());
  bad(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tip_.inverse(bad).status, Status::invalid);
  const VectorXd no_seed = VectorXd::Constant(mechanism_.dof, std::nan(""));
  EXPECT_EQ(tip_.inverse_next_to(pose(sampled()), no_seed).status, Status::invalid);
  EXPECT_TRUE(tip_.inverse_near(pose(sampled()), no_seed).rows.empty());
}

TEST_P(Arms, MotorsMoveTheTipAsTheJacobianSays) {
  const double step = 1e-5;
  int compared = 0;
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const VectorXd q = sampled();
    VectorXd ad(mechanism_.driven);
    for (double& rate : ad) rate = std::uniform_real_distribution<double>(-1, 1)(random_);
    const VectorXd qd = mechanism_.rates(q) * ad;
    // The inverse kinematics of where the tip has gone to, next to q, has turned the motors by their rates.
    VectorXd a(mechanism_.driven);
    for (int i = 0; i < mechanism_.driven; ++i)
      a[i] = q[mechanism_.driven_joints[static_cast<std::size_t>(i)]];
    const VectorXd moved = mechanism_.follow(a + step * ad, q);
    if (moved.size() == 0 || reference::gaps(reference_, moved).norm() > 1e-12) continue;
    const Set set = tip_.inverse_near(pose(moved), q);
    ASSERT_EQ(set.rows.size(), 1U);
    if (distance(set.rows.front().q, moved) > 1e-8) continue;  // the tip is nearly singular
    ++compared;
    const VectorXd twist = tip_.jacobian(q) * ad;
    const Eigen::Vector3d way = (pose(moved) - pose(q)).topRightCorner<3, 1>() / step;
    EXPECT_LT((twist.head<3>() - way).norm(), 1e-3 * (1 + qd.squaredNorm()));
  }
  EXPECT_GT(compared, QVGEN_LOOP_INPUTS / 2);
}

INSTANTIATE_TEST_SUITE_P(Loops, Arms, testing::ValuesIn(arms()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace qvgen::test::loops
