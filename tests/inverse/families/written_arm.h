// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "check.h"
#include "paths.h"
#include "pieces.h"
#include "rows_within.h"
#include "search.h"
#include "unsolved.h"

namespace qvgen::test {

/// Laws of every family of arms that are written, generated and compiled here.
class WrittenArm : public Inverse {
 protected:
  /// A search from random joints, the given one at its value, ends on nothing but rows.
  void expect_the_search_finds_nothing_else() {
    for (int i = 0; i < 3 && !HasFailure(); ++i) {
      const Sample sample = sample_at(test(), test().joints());
      const double given = test().given(sample.q);
      const Found found = test().robot().solve(sample.pose, given, 1e-12);
      for (const Eigen::VectorXd& q : search(test(), sample, 0, [&] { return start(given); }))
        EXPECT_TRUE(contains(test(), found, sample_at(test(), q)))
            << GetParam().name << " lacks " << q.transpose();
    }
  }

  /// Poses at which several things are singular at once, or next to it: the sampled joints are found, or the
  /// status says that some may be missing, which it may at one of fifty, or of so many; and nothing is wrong.
  void expect_found_or_told(const std::string& name, int one_of = 50) {
    int poses = 0, told = 0, untold = 0;
    std::string first;
    for (int i = 0; i < pose_count() / 20; ++i) {
      const std::optional<Sample> sample = draw(pose_set(name), i);
      if (!sample) continue;
      const Found found =
          test().robot().solve(sample->pose, test().given(sample->q), inverse::default_tolerance);
      const Verdict verdict = judge(test(), *sample, found);
      const bool lacks = verdict.missing || verdict.told;
      ++poses;
      told += lacks && found.status == Status::incomplete ? 1 : 0;
      untold += lacks && found.status != Status::incomplete ? 1 : 0;
      if (lacks && first.empty()) first = verdict.fault;
      EXPECT_TRUE(lacks || verdict.fault.empty()) << name << ", pose " << i << ": " << verdict.fault;
      EXPECT_EQ(verdict.bad + verdict.repeated, 0) << name << ", pose " << i << ": " << verdict.fault;
    }
    // README.md of tests/inverse says what elimination may lose untold.
    EXPECT_LE(untold, by_elimination() ? 1 + poses / 100 : 0) << name << ": " << first;
    EXPECT_LE(told, 1 + poses / one_of) << name << ": " << first;
    if (told + untold > 0)
      std::printf("%s, %s: %d of %d lack the sampled joints, %d of them untold\n", GetParam().name.c_str(),
                  name.c_str(), told + untold, poses, untold);
  }

  /// Expects a row on each piece of its circle on which a joint is free, or a status that says that some may
  /// be missing, as it may at one pose of fifty.
  void expect_a_row_on_every_piece() {
    int singular = 0, told = 0;
    const auto look_at = [&](const std::optional<Sample>& sample) {
      if (!sample || !is_on_a_curve(test(), *sample)) return;
      const Found found =
          test().robot().solve(sample->pose, test().given(sample->q), inverse::default_tolerance);
      const bool tells = found.status == Status::incomplete;
      singular += found.status == Status::singular || tells ? 1 : 0;
      told += tells ? 1 : 0;
      const auto is_row = [&](const Row& row) { return test().distance(row.q, sample->q) < 1e-3; };
      const bool is_found = tells || std::any_of(found.rows.begin(), found.rows.end(), is_row);
      EXPECT_TRUE(is_found || leads_to_a_row(test(), found, *sample))
          << GetParam().name << ": no row on the piece of " << sample->q.transpose();
    };
    for (int i = 0; i < pose_count() / 20; ++i) {
      for (const char* name : {"theta5 = 0", "theta5 = pi", "45° lattice"}) look_at(draw(pose_set(name), i));
      look_at(point_on_an_end_axis(test(), i));
    }
    EXPECT_LE(told, 1 + singular / 50);
  }

  /// Expects the joints that are the seed first within limits, at singular poses, next to them and where they
  /// are singular but for rounding; or a row that is marked. Where two things are singular at once the seed
  /// may be lost.
  void expect_the_seed_first_within_limits() {
    EXPECT_FALSE(rows_within(GetParam().name).empty());
    for (const auto& [language, call] : rows_within(GetParam().name)) {
      int asked = 0, lost = 0;
      for (const char* name : {"theta5 = 0", "theta5 = pi", "theta5 = 10^-u", "a joint at 10^-u"})
        for (int i = 0; i < pose_count() / 20; ++i)
          if (const std::optional<Sample> sample = draw(pose_set(name), i)) {
            ++asked;
            lost += loses_the_seed(call, *sample) ? 1 : 0;
          }
      for (int i = 0; i < pose_count() / 10; ++i) {
        ++asked;
        lost += loses_the_seed(call, straight_but_for_rounding(1 + i % (test().dof() - 2))) ? 1 : 0;
      }
      EXPECT_GT(asked, 0);
      EXPECT_LE(lost, 1 + asked / 100) << GetParam().name << " in " << language;
    }
  }

  /// As for the robots in tests/inverse/paths_test.cpp.
  void expect_no_jumps_next_to_a_seed() {
    int paths = 0, faults = 0;
    std::string first;
    const auto nearest = [&](const Pose<double>& pose, double given,
                             const Eigen::VectorXd& seed) -> std::optional<Eigen::VectorXd> {
      const Found found = GetParam().solve_near(pose, given, seed);
      if (found.rows.empty()) return std::nullopt;
      return found.rows.front().q;
    };
    for (const char* name : {"random", "theta5 = 0", "a joint at 0", "boundary"})
      for (int i = 0; i < pose_count() / 50; ++i) {
        const std::optional<Sample> sample = draw(pose_set(name), i);
        if (!sample) continue;
        const std::string fault = fault_along(test(), Path::through(test(), sample->q), nearest);
        ++paths;
        faults += fault.empty() ? 0 : 1;
        if (first.empty()) first = fault;
      }
    EXPECT_LE(faults, paths / 20) << first;
    if (faults > 0) std::printf("%s: %d of %d paths jump\n", GetParam().name.c_str(), faults, paths);
  }

  /// The budget that the arm's structure has is enough for all but a few poses in reach.
  void expect_few_poses_need_all_that_is_allowed() {
    inverse::Effort most;
    int poses = 0, cut_short = 0;
    for (const PoseSet& set : pose_sets())
      for (int i = 0; i < pose_count() / 50; ++i) {
        const std::optional<Sample> sample = draw(set, i);
        if (!sample || sample->expect != Expect::joints) continue;
        const inverse::Effort effort =
            test().robot().solve(sample->pose, test().given(sample->q), inverse::default_tolerance).effort;
        most.passes = std::max(most.passes, effort.passes);
        most.steps = std::max(most.steps, effort.steps);
        cut_short += effort.used_up ? 1 : 0;
        ++poses;
      }
    EXPECT_GT(poses, 0);
    EXPECT_LE(cut_short, poses / 33);
    std::printf(
        "%s: at most %d passes and %d evaluations, %d of %d poses in reach want more than is allowed\n",
        GetParam().name.c_str(), most.passes, most.steps, cut_short, poses);
  }

 private:
  /// The value of a joint at which the axes before and behind it are as near to each other as they come.
  double straight(Eigen::VectorXd q, int joint) {
    q[joint] = 0;
    const Eigen::MatrixXd axes = reference::jacobian(test().chain(), q).bottomRows(3);
    const Eigen::Vector3d axis = axes.col(joint), before = axes.col(joint - 1), behind = axes.col(joint + 1);
    const Eigen::Vector3d from = behind.cross(axis), to = before.cross(axis);
    return std::atan2(axis.dot(from.cross(to)), from.dot(to));
  }
  /// A joint is 10^-14 to 10^-10 rad off such a value, or off the opposite one.
  Sample straight_but_for_rounding(int joint) {
    Eigen::VectorXd q = test().joints();
    const double off = std::pow(10, -test().uniform(10, 14));
    q[joint] = straight(q, joint) + (test().uniform(-1, 1) < 0 ? 0 : pi) - off;
    q[joint] = std::remainder(q[joint], 2 * pi);
    return sample_at(test(), q);
  }

  bool loses_the_seed(const RowsWithin& call, const Sample& sample) {
    const Eigen::VectorXd& q = sample.q;
    const Found found = call(sample.pose, test().given(q), q, q.array() - 1, q.array() + 1);
    if (found.rows.empty()) return true;
    return test().distance(found.rows[0].q, q) > 2e-3 && !found.rows[0].continuum;
  }

  Eigen::VectorXd start(double given) {
    Eigen::VectorXd q = test().joints();
    if (GetParam().info.given_joint >= 0) q[GetParam().info.given_joint] = given;
    return q;
  }
};

}  // namespace qvgen::test
