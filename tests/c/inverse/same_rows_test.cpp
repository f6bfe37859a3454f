// SPDX-License-Identifier: MIT
// Inverse kinematics in C against that in C++, of every robot with a closed form, at ordinary poses and at those where
// solvers fail.
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "pose_sets.h"
#include "robot_in_c.h"

namespace qvgen::test {
namespace {

int pose_count() {
  const char* count = std::getenv("QVGEN_C_POSES");
  return count == nullptr ? 30 : std::atoi(count);
}

/// What was compared, for a line of the report.
struct Tally {
  int sets = 0, rows = 0, same_bits = 0, near_singular = 0;
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

  void expect_same(const Found& cxx, const Found& c, const std::string& what) {
    const bool is_regular = cxx.effort.passes == 0 && cxx.effort.steps == 0;
    ++tally_.sets;
    tally_.near_singular += is_regular ? 0 : 1;
    ASSERT_EQ(c.status, cxx.status) << what << "\nC++ " << text(cxx) << "\nC " << text(c);
    ASSERT_EQ(c.rows.size(), cxx.rows.size()) << what << "\nC++ " << text(cxx) << "\nC " << text(c);
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      ASSERT_EQ(c.rows[i].branch, cxx.rows[i].branch) << what << "\nC++ " << text(cxx) << "\nC " << text(c);
      ASSERT_EQ(c.rows[i].continuum, cxx.rows[i].continuum) << what << "\nC++ " << text(cxx) << "\nC " << text(c);
      const double off = test_.distance(c.rows[i].q, cxx.rows[i].q);
      ++tally_.rows;
      tally_.same_bits += c.rows[i].q == cxx.rows[i].q ? 1 : 0;
      tally_.largest = std::max(tally_.largest, off);
      ASSERT_LE(off, is_regular ? 1e-12 : 1e-9) << what << "\nC++ " << text(cxx) << "\nC " << text(c);
    }
  }

  /// One branch after the other, as C does, where there is a choice.
  [[nodiscard]] static Found solve(const InverseUnderTest& cxx, const Pose<double>& pose, double given, double tolerance) {
    return cxx.functions.solve_scalar ? cxx.solve_scalar(pose, given, tolerance) : cxx.solve(pose, given, tolerance);
  }

  void report(const char* what) const {
    std::printf("%-28s %-10s %6d sets, %5d near singular poses, %6d rows, %5.1f %% of them the same bits, largest "
                "difference %.1e\n",
                GetParam().name.c_str(), what, tally_.sets, tally_.near_singular, tally_.rows,
                100.0 * tally_.same_bits / std::max(1, tally_.rows), tally_.largest);
  }

  /// `ask(sample, name)` for samples of all sets of poses.
  template <class Ask>
  void for_all_poses(const Ask& ask) {
    for (const PoseSet& set : pose_sets()) {
      test_.seed(11);
      for (int i = 0; i < pose_count() && !HasFatalFailure(); ++i) {
        const std::optional<Sample> sample = set.draw(test_, i);
        if (!sample) break;
        ask(*sample, set.name + " " + std::to_string(i));
      }
    }
  }

  Case test_{GetParam()};
  const InverseFunctions* c_ = nullptr;
  Tally tally_;
};

TEST_P(SameRows, AllSolutions) {
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    for (const double tolerance : {inverse::default_tolerance, 1e-6})
      expect_same(solve(cxx, sample.pose, given, tolerance), c_->solve(sample.pose, given, tolerance, {}), name);
    if (c_->solve_pose)
      expect_same(cxx.functions.solve_pose(sample.pose, 1e-12), c_->solve_pose(sample.pose, 1e-12), name + ", pose");
  });
  report("all");
}

TEST_P(SameRows, FromASeed) {
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    const Eigen::VectorXd seed = test_.joints();
    expect_same(cxx.solve_from(sample.pose, given, seed), c_->solve_from(sample.pose, given, seed, {}), name);
    if (c_->solve_pose_from)
      expect_same(cxx.functions.solve_pose_from(sample.pose, seed), c_->solve_pose_from(sample.pose, seed),
                  name + ", pose");
  });
  report("seeded");
}

TEST_P(SameRows, NextToASeed) {
  if (!c_->solve_near) GTEST_SKIP() << "there is none for this arm";
  const InverseUnderTest& cxx = GetParam();
  for_all_poses([&](const Sample& sample, const std::string& name) {
    const double given = test_.given(sample.q);
    for (const double share : {1e-3, 1.0}) {
      const Eigen::VectorXd seed = sample.q + share * test_.joints();
      expect_same(cxx.solve_near(sample.pose, given, seed),
                  c_->solve_near(sample.pose, given, seed, inverse::default_tolerance, {}), name);
    }
  });
  report("near");
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
                  "other constants");
    }
  }
  report("constants");
}

INSTANTIATE_TEST_SUITE_P(Robots, SameRows, testing::ValuesIn(inverses()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
}  // namespace qvgen::test
