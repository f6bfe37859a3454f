// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "judge.h"
#include "nearly_free.h"

namespace qvgen::test {

/// Poses of a set: a quick run by default; the environment variable QVGEN_POSES=100000 asks for the full
/// size.
inline int pose_count() {
  const char* text = std::getenv("QVGEN_POSES");
  return text == nullptr ? 128 : std::atoi(text);
}

/// The end of a test's name: the robot's name.
inline std::string name_of(const testing::TestParamInfo<InverseUnderTest>& info) { return info.param.name; }

class Inverse : public testing::TestWithParam<InverseUnderTest> {
 protected:
  void SetUp() override { test_ = std::make_unique<Case>(GetParam()); }
  /// A set without a single pose of this arm is no test of it.
  void TearDown() override {
    if (asked_ && !drawn_ && !HasFailure()) GTEST_SKIP() << "the arm has no such pose";
  }
  Case& test() { return *test_; }

  /// From here on, an arm whose lengths are drawn at random.
  void change_geometry() {
    InverseUnderTest robot = GetParam();
    for (const std::string& name : robot.constants) robot.geometry[name] = test_->uniform(0.1, 1);
    test_ = std::make_unique<Case>(robot);
    test_->seed(++arms_);
  }

  /// Arms without a closed form: where solutions meet or the polynomial is flat one may be lost. README.md
  /// counts how many.
  static bool by_elimination() { return GetParam().info.by_elimination; }

  /// Poses of most sets: half as many, but for arms without a closed form, of which few in a thousand may be
  /// lost.
  static int usual_count() { return by_elimination() ? pose_count() : pose_count() / 2; }

  /// Tally of a whole set.
  struct Tally {
    int poses = 0;
    int empty = 0;
    int missing = 0;     ///< of arms without a closed form: sampled joints, untold
    int incomplete = 0;  ///< poses of which the status says that solutions may be missing
  };

  /// Away from singular poses next to nothing may be missing or in doubt.
  static void expect_few(const std::string& name, const Tally& tally) {
    const bool regular = name == "random";
    EXPECT_LE(tally.missing, regular ? tally.poses / 1000 : 1 + tally.poses / 1000) << name;
    EXPECT_LE(tally.incomplete, 1 + tally.poses / (regular ? 100 : 20)) << name;
  }

  std::optional<Sample> draw(const PoseSet& set, int i) {
    std::optional<Sample> sample = set.draw(test(), i);
    asked_ = true;
    drawn_ = drawn_ || sample;
    return sample;
  }

  /// Next to singular poses a row stands for the sampled joints, or the status says that some may be missing:
  /// at one pose of twenty, at most.
  void expect_a_row_next_to_singular_poses(int poses) {
    const LostRows result = lost_next_to_singular(test(), poses);
    EXPECT_GT(result.calls, 0);
    EXPECT_LE(result.told, 1 + result.calls / 20);
    EXPECT_EQ(result.lost, 0) << "of " << result.calls << " calls, the first: " << result.first;
  }

  /// Two singularities at once: a row stands for the sampled joints, or the status says that some may be
  /// missing, as it does at a fifth of these poses of a ur5. At one pose of so many neither need be. For arms
  /// of six joints.
  void expect_a_row_at_two_singularities(int poses) {
    if (GetParam().dof != 6 || GetParam().info.task != Task::pose || by_elimination())
      GTEST_SKIP() << "another law";
    const LostRows result = lost_at_two_singularities(test(), poses);
    if (result.calls == 0) GTEST_SKIP() << "the arm has no such pose";
    // A quartic's roots carry few digits there, and steps along a continuum use up what is allowed.
    const bool has_quartic = !GetParam().info.stable_branches;
    EXPECT_LE(result.told, 1 + (has_quartic ? 2 : 1) * result.calls / 3);
    EXPECT_LE(result.lost, result.calls / 500) << "of " << result.calls << " calls: " << result.first;
  }

  /// Every pose of a set, until one is wrong.
  Tally run(const std::string& name, int count = usual_count()) {
    const PoseSet& set = pose_set(name);
    Tally tally;
    for (int i = 0; i < count && !HasFailure(); ++i) {
      const std::optional<Sample> sample = draw(set, i);
      if (!sample) continue;
      const Found found =
          test().robot().solve(sample->pose, test().given(sample->q), inverse::default_tolerance);
      ++tally.poses;
      tally.empty += found.rows.empty() ? 1 : 0;
      tally.incomplete += found.status == Status::incomplete ? 1 : 0;
      const Verdict verdict = judge(test(), *sample, found);
      tally.missing += verdict.missing ? 1 : 0;
      EXPECT_TRUE(verdict.fault.empty()) << name << ", pose " << i << ": " << verdict.fault;
    }
    if (by_elimination()) expect_few(name, tally);
    return tally;
  }

 private:
  std::unique_ptr<Case> test_;
  unsigned arms_ = 0;
  bool asked_ = false, drawn_ = false;  ///< whether poses of sets were asked for, and any came
};

}  // namespace qvgen::test
