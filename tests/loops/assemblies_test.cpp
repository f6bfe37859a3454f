// SPDX-License-Identifier: MIT
// Assemblies of every mechanism: each closes all loops, none is missing, none is there twice; they are next
// to a seed; what cannot be assembled is said.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "assembly_laws.h"

namespace qvgen::test::loops {

namespace {

std::vector<MechanismUnderTest>& list() {
  static std::vector<MechanismUnderTest> all;
  return all;
}

}  // namespace

const std::vector<MechanismUnderTest>& mechanisms() { return list(); }
bool add_mechanism(MechanismUnderTest mechanism) {
  list().push_back(std::move(mechanism));
  return true;
}

namespace {

class Assemblies : public testing::TestWithParam<MechanismUnderTest> {
 protected:
  const MechanismUnderTest& mechanism_ = GetParam();
  const reference::LoopMechanism reference_ = reference::load_loops(mechanism_.description);
  const Effort effort_{QVGEN_LOOP_INPUTS, QVGEN_LOOP_STARTS};
  std::mt19937 random_{7};
};

TEST_P(Assemblies, AreThoseThatNewtonFindsFromManyStarts) {
  EXPECT_GT(compare(reference_, reference_.driven, mechanism_.assemble, effort_, random_),
            QVGEN_LOOP_INPUTS / 20);
}

TEST_P(Assemblies, OfAPlatformAreThoseThatNewtonFindsFromManyStarts) {
  if (!mechanism_.from_outputs) GTEST_SKIP() << "it has no platform";
  EXPECT_GT(compare(reference_, reference_.outputs, mechanism_.from_outputs, effort_, random_), 0);
}

TEST_P(Assemblies, HoldTheSampledOneAndAreNumberedInOrder) {
  std::mt19937 random(3);
  int sampled = 0;
  for (int k = 0; k < 200 && sampled < 50; ++k) {
    const VectorXd a = random_values(reference_, reference_.driven, random);
    const Set set = mechanism_.assemble(a);
    for (std::size_t i = 0; i < set.rows.size(); ++i) {
      if (i > 0) {
        EXPECT_LT(set.rows[i - 1].branch, set.rows[i].branch);
      }
      EXPECT_LT(set.rows[i].branch, mechanism_.capacity);
      const Set near = mechanism_.assemble_near(a, set.rows[i].q);
      ASSERT_EQ(near.rows.size(), set.rows.size());
      EXPECT_EQ(near.rows.front().branch, set.rows[i].branch);
      EXPECT_LT((near.rows.front().q - set.rows[i].q).norm(), 1e-12);
      ++sampled;
    }
  }
  EXPECT_GE(sampled, 20);
}

TEST_P(Assemblies, TakeAnglesNextToTheSeedByWholeTurns) {
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    const VectorXd a = random_values(reference_, reference_.driven, random);
    const Set set = mechanism_.assemble(a);
    if (set.rows.empty()) continue;
    VectorXd seed = set.rows.back().q;
    for (const int joint : mechanism_.passive_joints)
      if (reference_.chain.joints[static_cast<std::size_t>(joint)].revolute) seed[joint] += 4 * M_PI;
    seed = reference::followed(reference_, seed);
    const Set near = mechanism_.assemble_near(a, seed);
    EXPECT_LT((near.rows.front().q - seed).norm(), 1e-9);
  }
}

TEST_P(Assemblies, AreInvalidForWhatIsNoNumber) {
  VectorXd a = VectorXd::Zero(mechanism_.driven);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    a[0] = bad;
    const Set set = mechanism_.assemble(a);
    EXPECT_EQ(set.status, Status::invalid);
    EXPECT_TRUE(set.rows.empty());
  }
}

/// Joint in the order of whose angle assemblies are numbered, if an elimination gives all of them at once.
int numbering_joint(const std::string& name) {
  return name == "ankle" ? 0 : name == "planar_3rrr" || name == "planar_3rpr" ? 2 : -1;
}

int count_before(const Set& set, const Row& row, int joint) {
  return static_cast<int>(std::count_if(set.rows.begin(), set.rows.end(), [&](const Row& other) {
    return wrapped(other.q[joint]) < wrapped(row.q[joint]);
  }));
}

TEST_P(Assemblies, KeepTheirBranchAlongAPath) {
  const int joint = numbering_joint(mechanism_.name);
  std::mt19937 random(11);
  for (int k = 0; k < 20; ++k) {
    VectorXd a = random_values(reference_, reference_.driven, random);
    const Set begin = mechanism_.assemble(a);
    if (begin.rows.empty()) continue;
    VectorXd way(a.size());
    for (double& x : way) x = std::uniform_real_distribution<double>(-3e-3, 3e-3)(random);
    Row at = begin.rows.front();
    for (int step = 0; step < 100; ++step) {
      a += way;
      const Set near = mechanism_.assemble_near(a, at.q);
      if (near.rows.empty() || !is_apart(reference_, near) || mechanism_.drive_measure(at.q) < 1e-2) break;
      const Row& next = near.rows.front();
      if (distance(reference_, next.q, at.q) > 0.1) break;
      EXPECT_EQ(next.branch, joint < 0 ? at.branch : count_before(near, next, joint));
      at = next;
    }
  }
}

/// A short slide's square is rounding beside the squares of others.
TEST_P(Assemblies, CloseAsWellWhereASlideIsShort) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> power(-6, -2);
  for (const Eigen::Index joint : reference_.driven) {
    if (reference_.chain.joints[static_cast<std::size_t>(joint)].revolute) continue;
    for (int k = 0; k < 20; ++k) {
      VectorXd q = VectorXd::Zero(static_cast<Eigen::Index>(reference_.chain.joints.size()));
      q[joint] = reference_.size * std::pow(10, power(random));
      for (const VectorXd& assembled :
           reference::assemblies(reference_, q, {joint}, 1, static_cast<unsigned>(random()))) {
        const Set set = mechanism_.assemble(assembled(reference_.driven));
        expect_closed(reference_, set);
        EXPECT_TRUE(set.status == Status::incomplete || has(reference_, set, assembled, 1e-6));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Loops, Assemblies, testing::ValuesIn(mechanisms()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace qvgen::test::loops
