// SPDX-License-Identifier: MIT
// Inverse kinematics in C against that in C++, of every robot with a closed form, at ordinary poses and at
// those where solvers fail.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "left_out.h"
#include "pose_sets.h"
#include "robot_in_c.h"

namespace qvgen::test {
namespace {

int pose_count() {
  const char* count = std::getenv("QVGEN_C_POSES");
  return count == nullptr ? 30 : std::atoi(count);
}

/// Number of comparisons, for a line of the report.
struct Tally {
  int sets = 0, singular = 0, other = 0, rows = 0, same_bits = 0;
  double largest = 0;
};

std::string text(const Found& found) {
  std::string result = "status " + std::to_string(static_cast<int>(found.status)) + ", " +
                       std::to_string(found.effort.passes) + " passes";
  for (const Row& row : found.rows) {
    result += "\n  " + std::to_string(row.branch) + (row.continuum ? " free" : "     ");
    for (const double q : row.q) result += " " + std::to_string(q);
  }
  return result;
}

class SameRows : public testing::TestWithParam<InverseUnderTest> {
 protected:
  void SetUp() override {
    if (GetParam().info.by_elimination) GTEST_SKIP() << "by elimination: C++ alone";
    const auto place = inverses_in_c().find(GetParam().name);
    ASSERT_NE(place, inverses_in_c().end());
    c_ = &place->second;
  }

  /// Near a singular pose Newton's steps from a seed magnify what rounding leaves: these may lead elsewhere.
  /// They may not anywhere else.
  void expect_same(const Found& cxx, const Found& c, const Sample& sample, const std::string& what) {
    const bool is_regular = cxx.effort.passes == 0 && cxx.effort.steps == 0 &&
                            cxx.status != Status::singular && GetParam().info.stable_branches &&
                            is_one_by_one();
    const std::string both = what + "\nC++ " + text(cxx) + "\nC " + text(c);
    ++tally_.sets;
    tally_.singular += is_regular ? 0 : 1;
    const std::string difference = different(cxx, c, is_regular ? 1e-12 : 1e-9);
    if (is_regular || cxx.status == Status::invalid || c.status == Status::invalid) {
      ASSERT_EQ(difference, "") << both;
    }
    if (difference.empty()) return count_rows(cxx, c);
    ++tally_.other;
    expect_right(c, sample, both);
  }

  /// True if both compute the same; else lanes are compared with one branch after the other, and seeds have
  /// other sines, which a wrist that is nearly straight magnifies.
  [[nodiscard]] static bool is_one_by_one() { return static_cast<bool>(GetParam().functions.solve_scalar); }

  [[nodiscard]] std::string different(const Found& cxx, const Found& c, double tolerance) const {
    if (c.status != cxx.status) return "status";
    if (c.rows.size() != cxx.rows.size()) return "number of rows";
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      if (c.rows[i].branch != cxx.rows[i].branch) return "branch";
      if (c.rows[i].continuum != cxx.rows[i].continuum) return "mark";
      if (const double off = test_.distance(c.rows[i].q, cxx.rows[i].q); !(off <= tolerance))
        return "values, by " + std::to_string(off * 1e12) + "e-12";
    }
    return "";
  }

  void count_rows(const Found& cxx, const Found& c) {
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      ++tally_.rows;
      tally_.same_bits += c.rows[i].q == cxx.rows[i].q ? 1 : 0;
      tally_.largest = std::max(tally_.largest, test_.distance(c.rows[i].q, cxx.rows[i].q));
    }
  }

  /// Laws of every set: each row reaches the pose, none is there twice.
  void expect_right(const Found& c, const Sample& sample, const std::string& what) const {
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      ASSERT_LE(test_.miss(c.rows[i].q, sample.target).largest(), 1e-9 + 10 * tolerance_) << what;
      for (std::size_t k = 0; k < i; ++k) ASSERT_GT(test_.distance(c.rows[i].q, c.rows[k].q), 1e-8) << what;
    }
  }

  /// One branch after the other, as C does, where there is a choice.
  [[nodiscard]] static Found solve(const InverseUnderTest& cxx, const Pose<double>& pose, double given,
                                   double tolerance) {
    return cxx.functions.solve_scalar ? cxx.solve_scalar(pose, given, tolerance)
                                      : cxx.solve(pose, given, tolerance);
  }

  /// Distance from the seed of the row that is nearest to it, angles the short way round.
  [[nodiscard]] double least_apart(const Found& found, const Eigen::VectorXd& seed) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Row& row : found.rows) {
      double square = 0;
      for (int k = 0; k < test_.dof(); ++k) {
        const double way = row.q[k] - seed[k];
        const double off = test_.revolute(k) ? std::remainder(way, 2 * pi) : way;
        square += off * off;
      }
      least = std::min(least, std::sqrt(square));
    }
    return least;
  }

  /// So many of a hundred sets near singular poses, and one, may be others; none for 0.
  void report(const char* what, int others) const {
    EXPECT_LE(100 * tally_.other, others == 0 ? 0 : 100 + others * tally_.singular);
    std::printf(
        "%-24s %-9s %5d sets, %4d of them singular, %3d of these others; %6d rows, %5.1f %% the same bits, "
        "largest "
        "difference %.1e\n",
        GetParam().name.c_str(), what, tally_.sets, tally_.singular, tally_.other, tally_.rows,
        100.0 * tally_.same_bits / std::max(1, tally_.rows), tally_.largest);
  }

  /// `ask(sample, name)` for samples of all sets of poses.
  template <class Ask>
  void for_all_poses(const Ask& ask) {
    for (const PoseSet& set : pose_sets()) {
      test_.seed(11);
      // An arm of seven joints has a function for each joint that may be given.
      const int share = is_one_by_one() ? 1 : test_.dof() > 6 ? 10 : 3;
      const int count = pose_count() / share;
      for (int i = 0; i < count && !HasFatalFailure(); ++i) {
        const std::optional<Sample> sample = set.draw(test_, i);
        if (!sample) break;
        ask(*sample, set.name + " " + std::to_string(i));
      }
    }
  }

  Case test_{GetParam()};
  const InverseFunctions* c_ = nullptr;
  double tolerance_ = inverse::default_tolerance;  ///< that is asked with
  Tally tally_;
};

TEST_P(SameRows, AllSolutions) {
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    for (const double tolerance : {inverse::default_tolerance, 1e-6}) {
      tolerance_ = tolerance;
      expect_same(solve(cxx, sample.pose, given, tolerance), c_->solve(sample.pose, given, tolerance, {}),
                  sample, name);
    }
    if (c_->solve_pose)
      expect_same(cxx.functions.solve_pose(sample.pose, 1e-12), c_->solve_pose(sample.pose, 1e-12), sample,
                  name + ", pose");
  });
  report("all", is_one_by_one() ? 0 : 1);
}

TEST_P(SameRows, FewDigitsAreThePoseThatTheyMean) {
  for (int i = 0; i < 40; ++i) {
    const Eigen::VectorXd q = test_.joints();
    Pose<double> pose = Pose<double>::from_isometry(test_.tool(q));
    for (double& x : pose.orientation.coeffs()) x = std::round(x * 1e4) / 1e4;
    const double given = test_.given(q);
    const Found few = c_->solve(pose, given, tolerance_, {});
    const Found meant = c_->solve(pose.normalised(), given, tolerance_, {});
    ASSERT_NE(few.status, Status::invalid);
    ASSERT_EQ(different(meant, few, 1e-9), "");
  }
}

TEST_P(SameRows, FromASeed) {
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    const Eigen::VectorXd seed = test_.joints();
    expect_same(cxx.solve_from(sample.pose, given, seed), c_->solve_from(sample.pose, given, seed, {}),
                sample, name);
    if (c_->solve_pose_from)
      expect_same(cxx.functions.solve_pose_from(sample.pose, seed), c_->solve_pose_from(sample.pose, seed),
                  sample, name + ", pose");
  });
  report("seeded", most_others());
}

TEST_P(SameRows, NextToASeed) {
  if (!c_->solve_near) GTEST_SKIP() << "there is none for this arm";
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    for (const double share : {1e-3, 1.0}) {
      const Eigen::VectorXd seed = sample.q + share * test_.joints();
      expect_same(cxx.solve_near(sample.pose, given, seed),
                  c_->solve_near(sample.pose, given, seed, inverse::default_tolerance, {}), sample, name);
    }
  });
  report("near", most_others());
}

/// Law: next to a seed at any distance, in C and in C++, there is the row of all that is nearest to it. Of a
/// direction, the turn about it counts as one more joint, which no row shows.
TEST_P(SameRows, NextToASeedIsTheNearestOfAll) {
  if (!c_->solve_near) GTEST_SKIP() << "there is none for this arm";
  const InverseUnderTest& cxx = GetParam();
  if (cxx.info.task == Task::direction || cxx.info.task == Task::position_and_direction)
    GTEST_SKIP() << "asked for a direction";
  if (!cxx.info.stable_branches) GTEST_SKIP() << "of a quartic the nearest root is followed";
  int looked_at = 0;
  for (int i = 0; i < 2 * pose_count(); ++i) {
    const Sample sample = sample_at(test_, test_.joints());
    const double given = test_.given(sample.q);
    for (const double radians : {3e-3, 0.1, 1.0, 3.0}) {
      const Eigen::VectorXd seed = sample.q + radians / pi * test_.joints();
      const Found all = solve(cxx, sample.pose, given, inverse::default_tolerance);
      if (all.status != Status::solved || all.effort.passes > 0) continue;
      const double least = least_apart(all, seed);
      const std::string what = std::to_string(i) + ", " + std::to_string(radians) + " rad\n" + text(all);
      const Found in_c = c_->solve_near(sample.pose, given, seed, inverse::default_tolerance, {});
      const Found in_cxx = cxx.solve_near(sample.pose, given, seed);
      for (const Found* near : {&in_c, &in_cxx}) {
        const std::string both = what + (near == &in_c ? "\nC " : "\nC++ ") + text(*near);
        ASSERT_EQ(near->rows.size(), 1U) << both;
        ASSERT_LE(test_.miss(near->rows[0].q, sample.target).largest(), 1e-9) << both;
        EXPECT_LE(least_apart(*near, seed), least + 1e-9) << both;
      }
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 0);
  std::printf("%-24s nearest of all, %d seeds\n", cxx.name.c_str(), looked_at);
}

/// The angle q + 2 pi k inside the limits that is nearest to the seed; false if there is none.
bool representative(double lower, double upper, double seed, double& q) {
  std::optional<double> best;
  for (int k = -4; k <= 4; ++k) {
    const double angle = q + 2 * pi * k;
    const bool inside = angle >= lower && angle <= upper;
    if (inside && (!best || std::abs(angle - seed) < std::abs(*best - seed))) best = angle;
  }
  q = best.value_or(q);
  return best.has_value();
}

TEST_P(SameRows, WithinLimits) {
  if (!c_->solve_within) GTEST_SKIP() << "not asked here";
  int left_out = 0, kept = 0;
  for (int i = 0; i < 4 * pose_count(); ++i) {
    const Sample sample = sample_at(test_, test_.joints());
    const double given = test_.given(sample.q);
    Eigen::VectorXd lower = sample.q, upper = sample.q;
    for (int k = 0; k < test_.dof(); ++k) {
      lower[k] -= test_.uniform(0, 8);
      upper[k] += test_.uniform(0, 8);
    }
    const Eigen::VectorXd seed = (lower + upper) / 2;
    Found expected = c_->solve_from(sample.pose, given, seed, {});
    std::erase_if(expected.rows, [&](Row& row) {
      bool inside = true;
      for (int k = 0; k < test_.dof() && inside; ++k)
        inside = test_.revolute(k) ? representative(lower[k], upper[k], seed[k], row.q[k])
                                   : row.q[k] >= lower[k] && row.q[k] <= upper[k];
      left_out += inside ? 0 : 1;
      return !inside;
    });
    std::stable_sort(expected.rows.begin(), expected.rows.end(),
                     [&](const Row& a, const Row& b) { return (a.q - seed).norm() < (b.q - seed).norm(); });
    const Found found = c_->solve_within(sample.pose, given, lower, upper);
    ASSERT_EQ(found.rows.size(), expected.rows.size()) << text(expected) << "\n" << text(found);
    for (std::size_t k = 0; k < found.rows.size(); ++k) {
      ASSERT_LE((found.rows[k].q - expected.rows[k].q).norm(), 1e-12);
      ASSERT_EQ(found.rows[k].branch, expected.rows[k].branch);
      ++kept;
    }
    if (found.rows.empty()) {
      ASSERT_NE(found.status, Status::solved);
    }
  }
  EXPECT_GT(kept, 0);
  std::printf("%-24s within limits %d rows, %d left out\n", GetParam().name.c_str(), kept, left_out);
}

/// The row without limits, where it is within them; none elsewhere, and no other.
TEST_P(SameRows, NextToASeedWithinLimits) {
  const auto place = near_within_in_c().find(GetParam().name);
  if (place == near_within_in_c().end()) GTEST_SKIP() << "there is none for this arm";
  int kept = 0, dropped = 0;
  for (int i = 0; i < 4 * pose_count(); ++i) {
    const Sample sample = sample_at(test_, test_.joints());
    const double given = test_.given(sample.q);
    const Eigen::VectorXd seed = sample.q + 0.01 * test_.joints();
    Eigen::VectorXd lower = sample.q, upper = sample.q;
    for (int k = 0; k < test_.dof(); ++k) {
      lower[k] -= test_.uniform(-0.1, 2);
      upper[k] += test_.uniform(-0.1, 2);
    }
    const Found free = c_->solve_near(sample.pose, given, seed, inverse::default_tolerance, {});
    const Found found = place->second(sample.pose, given, seed, lower, upper);
    const bool inside = !free.rows.empty() && (free.rows[0].q.array() >= lower.array()).all() &&
                        (free.rows[0].q.array() <= upper.array()).all();
    ASSERT_EQ(found.rows.size(), inside ? 1U : 0U) << text(free);
    ASSERT_EQ(found.status, inside || free.rows.empty() ? free.status : Status::unreachable);
    if (inside) {
      ASSERT_EQ(found.rows[0].q, free.rows[0].q);
    }
    ++(inside ? kept : dropped);
    if (!inside || i % 4 != 0) continue;
    // On a limit but for rounding is on it.
    upper[0] = free.rows[0].q[0] - 1e-13;
    const Found clamped = place->second(sample.pose, given, seed, lower, upper);
    ASSERT_EQ(clamped.rows.size(), lower[0] <= upper[0] ? 1U : 0U);
    if (!clamped.rows.empty()) {
      ASSERT_EQ(clamped.rows[0].q[0], upper[0]);
    }
  }
  EXPECT_GT(kept, 0);
  EXPECT_GT(dropped, 0);
}

/// Law: C and C++ go through the same representatives in the same order, bit by bit.
TEST_P(SameRows, Representatives) {
  const auto place = representatives_in_c().find(GetParam().name);
  if (place == representatives_in_c().end()) GTEST_SKIP() << "looked at for the committed robots";
  std::size_t most = 0;
  for (int i = 0; i < pose_count(); ++i) {
    const Sample sample = sample_at(test_, test_.joints());
    Eigen::VectorXd lower = sample.q, upper = sample.q;
    for (int k = 0; k < test_.dof(); ++k) {
      // Up to three turns to either side of some joints, limits on the joints themselves and none.
      const double way = k == i % test_.dof() ? 20 : 4;
      lower[k] -= i % 7 == 0 ? 0 : test_.uniform(0, way);
      upper[k] += test_.uniform(0, way);
      if (i % 11 == k) upper[k] = std::numeric_limits<double>::infinity();
    }
    const auto all = place->second(sample.pose, test_.given(sample.q), lower, upper);
    ASSERT_EQ(all.c.size(), all.cxx.size());
    for (std::size_t k = 0; k < all.c.size(); ++k) {
      ASSERT_EQ(all.c[k].q, all.cxx[k].q) << k;
      ASSERT_EQ(all.c[k].branch, all.cxx[k].branch);
    }
    most = std::max(most, all.c.size());
  }
  EXPECT_GT(most, 2U);
}

TEST_P(SameRows, OtherConstants) {
  InverseUnderTest cxx = GetParam();
  if (cxx.constants.empty()) GTEST_SKIP() << "all constants of this arm are numbers";
  for (int i = 0; i < 3; ++i) {
    for (const std::string& name : cxx.constants) cxx.geometry[name] = test_.uniform(0.2, 1);
    Case other(cxx);
    for (int k = 0; k < pose_count(); ++k) {
      const Sample sample = sample_at(other, other.joints());
      const double given = other.given(sample.q);
      expect_same(solve(cxx, sample.pose, given, 1e-13), c_->solve(sample.pose, given, 1e-13, cxx.geometry),
                  sample, "other constants");
    }
  }
  report("constants", 0);
}

bool is_in_cxx_alone(const InverseUnderTest& arm) {
  return !arm.info.by_elimination && !inverses_in_c().contains(arm.name);
}

std::vector<InverseUnderTest> in_both_languages() {
  std::vector<InverseUnderTest> arms;
  std::copy_if(
      inverses().begin(), inverses().end(), std::back_inserter(arms),
      [](const InverseUnderTest& arm) { return !in_c_alone().contains(arm.name) && !is_in_cxx_alone(arm); });
  return arms;
}
INSTANTIATE_TEST_SUITE_P(Robots, SameRows, testing::ValuesIn(in_both_languages()),
                         [](const auto& robot) { return robot.param.name; });

TEST(RobotsInC, NoOthersAreLeftOut) {
  EXPECT_EQ(std::count_if(inverses().begin(), inverses().end(), is_in_cxx_alone), left_out_of_c());
}

}  // namespace
}  // namespace qvgen::test
