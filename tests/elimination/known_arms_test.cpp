// SPDX-License-Identifier: MIT
// Arms of the literature and arms one can buy, written down in arms.cpp.
#include <cstdlib>

#include <gtest/gtest.h>

#include "check.h"

namespace qvgen::test {
namespace {

using inverse::elimination::Found;
using Constants = inverse::elimination::Setup;

class GeneralArm : public testing::TestWithParam<Arm> {
 protected:
  const Arm& arm_ = GetParam();
  Constants setup_ = inverse::elimination::set_up(arm_.description());
  Random random_{7};

  Found solve_at(const Joints6& q, InstructionSet set = InstructionSet::avx512) {
    const Eigen::Isometry3d target = arm_.tool(q);
    const Found found = solve(setup_, Pose<double>::from_isometry(target), set);
    EXPECT_EQ(fault(arm_, target, found), "");
    return found;
  }
};

TEST_P(GeneralArm, FindsTheSampledJoints) {
  for (const InstructionSet set : instruction_sets) {
    int unsure = 0;
    for (int i = 0; i < pose_count(400); ++i) {
      const Joints6 q = arm_.joints(random_);
      const Found found = solve_at(q, set);
      unsure += found.status == Status::incomplete ? 1 : 0;
      EXPECT_TRUE(contains(arm_, found, q) || found.status == Status::incomplete) << "pose " << i;
    }
    EXPECT_LE(unsure, pose_count(400) / 100);
  }
}

TEST_P(GeneralArm, EverySetFindsTheSame) {
  for (int i = 0; i < pose_count(400) / 10; ++i) {
    const Joints6 q = arm_.joints(random_);
    const Found baseline = solve_at(q, InstructionSet::baseline);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
      const Found lanes = solve_at(q, set);
      ASSERT_EQ(lanes.size(), baseline.size()) << "pose " << i;
      for (const auto& row : baseline) EXPECT_TRUE(contains(arm_, lanes, row.q)) << "pose " << i;
    }
  }
}

/// Every elimination that is kept finds all, alone: as many as all together.
TEST_P(GeneralArm, EliminationsAgree) {
  for (int i = 0; i < pose_count(400) / 50; ++i) {
    const Joints6 q = arm_.joints(random_);
    const Found found = solve_at(q);
    if (found.status == Status::incomplete) continue;
    for (int k = 1; k < setup_.count; ++k) {
      Constants other = setup_;
      std::swap(other.eliminations[0], other.eliminations[k]);
      const Found same = solve(other, Pose<double>::from_isometry(arm_.tool(q)));
      EXPECT_TRUE(same.size() == found.size() || same.status == Status::incomplete)
          << same.size() << " for " << found.size() << "pose " << i << ", elimination " << k;
    }
  }
}

TEST_P(GeneralArm, InvalidAndUnreachablePoses) {
  Pose<double> pose = Pose<double>::from_isometry(arm_.tool(arm_.joints(random_)));
  pose.position *= 100;
  EXPECT_EQ(solve(setup_, pose).status, Status::unreachable);
  pose.position[1] = std::nan("");
  EXPECT_EQ(solve(setup_, pose).status, Status::invalid);
  pose = Pose<double>::identity();
  pose.orientation.coeffs() *= 2;
  EXPECT_EQ(solve(setup_, pose).status, Status::invalid);
}

INSTANTIATE_TEST_SUITE_P(Named, GeneralArm, testing::ValuesIn(named_arms()), name_of);

/// The pose of the paper's title.
TEST(ManseurDoty, SixteenSolutions) {
  const Arm arm = manseur_doty();
  Eigen::Isometry3d target;
  target.matrix() << -0.760117, -0.641689, 0.102262, -1.140175, 0.133333, 0, 0.991071, 0, -0.635959, 0.766965,
      0.085558, 0, 0, 0, 0, 1;
  target.linear() = Eigen::Quaterniond(target.linear()).normalized().toRotationMatrix();
  const Found found =
      solve(inverse::elimination::set_up(arm.description()), Pose<double>::from_isometry(target));
  EXPECT_EQ(found.size(), 16);
  EXPECT_EQ(found.status, Status::solved);
  EXPECT_EQ(fault(arm, target, found), "");
}

/// Coincident axes, and no two of them apart.
TEST(GeneralArms, SingularEverywhereAreRefused) {
  Arm arm = raghavan_roth();
  arm.links[2] = Eigen::Translation3d(0, 0, 0.5) * Eigen::Isometry3d::Identity();
  EXPECT_EQ(inverse::elimination::set_up(arm.description()).count, 0);
  for (Eigen::Isometry3d& link : arm.links) link.translation().setZero();
  EXPECT_EQ(inverse::elimination::set_up(arm.description()).count, 0);
}

}  // namespace
}  // namespace qvgen::test
