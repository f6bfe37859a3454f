// SPDX-License-Identifier: MIT
// Assemblies of every mechanism: each closes all loops, none is missing, none is there twice; they are next
// to a seed; what cannot be assembled is said.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "mechanism_under_test.h"
#include "reference/loops.h"

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

constexpr int starts = 150;

double wrapped(double angle) { return std::remainder(angle, 2 * M_PI); }

double distance(const reference::LoopMechanism& of, const VectorXd& a, const VectorXd& b) {
  double worst = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const bool turns = of.chain.joints[static_cast<std::size_t>(i)].revolute;
    worst = std::max(worst, std::abs(turns ? wrapped(a[i] - b[i]) : a[i] - b[i]));
  }
  return worst;
}

bool has(const reference::LoopMechanism& of, const Set& set, const VectorXd& q, double within) {
  return std::any_of(set.rows.begin(), set.rows.end(),
                     [&](const Row& row) { return distance(of, row.q, q) < within; });
}

/// Values for some joints: any, slides within the mechanism's size; or, in every second case, those of an
/// assembly.
VectorXd random_values(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& joints,
                       std::mt19937& random) {
  std::uniform_real_distribution<double> turn(-3.2, 3.2), slide(-of.size / 2, of.size / 2);
  const auto count = static_cast<Eigen::Index>(of.chain.joints.size());
  const auto assembled = random() % 2 == 0 ? reference::assemblies(of, VectorXd::Zero(count), {}, 1,
                                                                   static_cast<unsigned>(random()))
                                           : std::vector<VectorXd>{};
  VectorXd values(static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::Index joint = joints[static_cast<std::size_t>(i)];
    const bool turns = of.chain.joints[static_cast<std::size_t>(joint)].revolute;
    values[i] = !assembled.empty() ? assembled[0][joint] : turns ? turn(random) : slide(random);
  }
  return values;
}

VectorXd with_values(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& joints,
                     const VectorXd& values) {
  VectorXd q = VectorXd::Zero(static_cast<Eigen::Index>(of.chain.joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) q[joints[i]] = values[static_cast<Eigen::Index>(i)];
  return q;
}

void expect_closed(const reference::LoopMechanism& of, const Set& set) {
  for (const Row& row : set.rows) {
    EXPECT_LT(reference::gaps(of, row.q).cwiseAbs().maxCoeff(), 1e-13 * of.size);
    for (const Row& other : set.rows)
      if (&other != &row) {
        EXPECT_GT(distance(of, row.q, other.q), 1e-9) << "an assembly is there twice";
      }
  }
}

/// Two assemblies that meet are hard for Newton's steps, and not counted.
bool is_apart(const reference::LoopMechanism& of, const Set& set) {
  for (const Row& row : set.rows)
    for (const Row& other : set.rows)
      if (row.meets || (&row != &other && distance(of, row.q, other.q) < 1e-3)) return false;
  return true;
}

/// Inputs at which the rows are those that Newton's steps find from many starts. Returns how many assemblies
/// there were.
int compare(const reference::LoopMechanism& of, const std::vector<Eigen::Index>& given,
            const std::function<Set(const VectorXd&)>& solve) {
  std::mt19937 random(7);
  int assemblies = 0;
  for (int k = 0; k < QVGEN_LOOP_INPUTS; ++k) {
    const VectorXd values = random_values(of, given, random);
    const VectorXd q = with_values(of, given, values);
    const Set set = solve(values);
    expect_closed(of, set);
    EXPECT_EQ(set.status, set.rows.empty() ? Status::unreachable : Status::solved);
    assemblies += static_cast<int>(set.rows.size());
    if (!is_apart(of, set)) continue;
    for (const VectorXd& other : reference::assemblies(of, q, given, starts, static_cast<unsigned>(k)))
      EXPECT_TRUE(has(of, set, other, 1e-6))
          << "missing: " << other.transpose() << " for " << values.transpose();
  }
  return assemblies;
}

class Assemblies : public testing::TestWithParam<MechanismUnderTest> {
 protected:
  const MechanismUnderTest& mechanism_ = GetParam();
  const reference::LoopMechanism reference_ = reference::load_loops(mechanism_.description);
};

TEST_P(Assemblies, AreThoseThatNewtonFindsFromManyStarts) {
  EXPECT_GT(compare(reference_, reference_.driven, mechanism_.assemble), QVGEN_LOOP_INPUTS / 20);
}

TEST_P(Assemblies, OfAPlatformAreThoseThatNewtonFindsFromManyStarts) {
  if (!mechanism_.from_outputs) GTEST_SKIP() << "it has no platform";
  EXPECT_GT(compare(reference_, reference_.outputs, mechanism_.from_outputs), 0);
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

INSTANTIATE_TEST_SUITE_P(Loops, Assemblies, testing::ValuesIn(mechanisms()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace qvgen::test::loops
