// SPDX-License-Identifier: MIT
// Random paths of arms of every structure, some by elimination: compared with all solutions at places a
// hundred times denser no motion is lost, none invented, and every end is explained; the way back gives the
// same motions, and the halves of a path give motions that join.
#include <gtest/gtest.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace path_test {
namespace {

constexpr std::size_t poses = 12;

class PathLaws : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const AnyArm& arm() { return arm_called(GetParam()).arm; }

  template <class Check>
  static void for_each_path(int usual, const Check& check) {
    std::mt19937 random(7);
    // A pose of an arm by elimination takes some fifty times as long.
    const int count = path_count(GetParam() == "crx10ia" ? std::max(1, usual / 4) : usual);
    for (int i = 0; i < count; ++i) {
      const double length = i % 3 == 0 ? 0.2 : i % 3 == 1 ? 0.6 : 1.5;
      SCOPED_TRACE(GetParam() + ", path " + std::to_string(i));
      check(random_path(arm(), random, poses, length));
    }
  }
};

bool is_alive(const Track& track, double s) { return track.begin.s < s && s < track.end.s; }

/// True if the rows at a place beyond `alive` are gone at both sides within the way that two places of the
/// follower may be apart: a branch that begins and ends there can be missed, as the library says.
bool is_between_places(const AnyArm& arm, const Curve& curve, double s, std::ptrdiff_t alive) {
  const Options options;
  const auto piece = curve.piece(std::min(static_cast<std::size_t>(s), curve.pieces() - 1));
  const double apart =
      2 * std::min(options.longest_way / piece.distance(), options.longest_turn / piece.angle());
  return arm.solve(curve.at(std::max(0.0, s - apart))).size() <= alive &&
         arm.solve(curve.at(std::min(curve.end(), s + apart))).size() <= alive;
}

bool is_near_an_end(const std::vector<Track>& tracks, double s) {
  for (const Track& track : tracks)
    if (std::abs(track.begin.s - s) < 1e-6 || std::abs(track.end.s - s) < 1e-6) return true;
  return false;
}

TEST_P(PathLaws, NoMotionIsLostAndNoneInvented) {
  int compared = 0, paths = 0, hidden = 0;
  for_each_path(6, [&](const std::vector<Pose<double>>& samples) {
    const Whole whole(arm(), samples);
    EXPECT_FALSE(whole.record.is_full);
    ++paths;
    const std::vector<Track> tracks = whole.found();
    const int places = 100 * static_cast<int>(whole.curve.pieces());
    for (int i = 0; i <= places; ++i) {
      const double s = whole.curve.end() * (i + 0.37) / (places + 1);
      const auto found = arm().solve(whole.curve.at(s));
      if (found.status == Status::singular || found.status == Status::incomplete) continue;
      if (is_near_an_end(tracks, s)) continue;
      const auto alive =
          std::count_if(tracks.begin(), tracks.end(), [&](const Track& track) { return is_alive(track, s); });
      ++compared;
      if (alive < found.size() && is_between_places(arm(), whole.curve, s, alive)) {
        ++hidden;
        continue;
      }
      ASSERT_EQ(alive, found.size()) << "s = " << s;
    }
  });
  EXPECT_GT(compared, 400 * paths);
  EXPECT_LE(hidden, compared / 500);
}

/// Joins rows by distance from place to place, a hundred for each piece.
Values followed(const AnyArm& arm, const Curve& curve, Values q, double from, double to) {
  const int places = 100 + static_cast<int>(400 * (to - from));
  for (int i = 1; i <= places; ++i) {
    const auto found = arm.solve(curve.at(from + (to - from) * i / places));
    double least = 1e9;
    Values next = q;
    for (const auto& row : found) {
      const Values way = difference(row.q, q, arm.revolute);
      if (way.norm() < least) {
        least = way.norm();
        next = q + way;
      }
    }
    q = next;
  }
  return q;
}

TEST_P(PathLaws, JointsAtTheSamplesAreThoseOfDenseSteps) {
  int compared = 0;
  for_each_path(3, [&](const std::vector<Pose<double>>& samples) {
    const Whole whole(arm(), samples);
    for (int number = 0; number < whole.record.tracks(); ++number) {
      for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        Values here, next;
        if (!whole.record.at(i, number, here) || !whole.record.at(i + 1, number, next)) continue;
        EXPECT_LT(linear_distance(arm().forward(here), samples[i]), 1e-9);
        EXPECT_LT(angular_distance(arm().forward(here), samples[i]), 1e-9);
        const double s = static_cast<double>(i);
        const Values other = followed(arm(), whole.curve, here, s, s + 1);
        ++compared;
        if ((next - here).norm() < 0.5) {
          EXPECT_LT((next - other).cwiseAbs().maxCoeff(), 1e-6) << "track " << number << ", sample " << i;
        }
      }
    }
  });
  EXPECT_GT(compared, 50);
}

/// A meeting has the joints of both tracks, which reach the pose, where the Jacobian is singular.
void expect_meeting(const AnyArm& arm, const Whole& whole, const End& end, const End& other) {
  EXPECT_NEAR(end.s, other.s, 1e-9);
  EXPECT_LT(difference(end.q, other.q, arm.revolute).norm(), 1e-6);
  const Pose<double> pose = whole.curve.at(end.s);
  EXPECT_LT(linear_distance(arm.forward(end.q), pose), 1e-9);
  EXPECT_LT(angular_distance(arm.forward(end.q), pose), 1e-9);
  const Eigen::VectorXd values = reference::spectrum(arm.jacobian(end.q));
  EXPECT_LT(values[5], 1e-6 * values[0]);
}

/// Solutions at a place, or -1 if not sure.
int count_at(const AnyArm& arm, const Curve& curve, double s) {
  const auto found = arm.solve(curve.at(s));
  return found.status == Status::singular || found.status == Status::incomplete ? -1 : found.size();
}

TEST_P(PathLaws, EveryEndIsExplained) {
  int ends = 0;
  for_each_path(20, [&](const std::vector<Pose<double>>& samples) {
    const Whole whole(arm(), samples);
    for (const Track& track : whole.found())
      for (const End* end : {&track.begin, &track.end}) {
        const bool is_begin = end == &track.begin;
        EXPECT_NE(end->cause, Cause::unclear) << end->s;
        EXPECT_NE(end->cause, Cause::limit);
        if (end->cause == Cause::path_end) {
          EXPECT_EQ(end->s, is_begin ? 0 : whole.curve.end());
        }
        if (end->cause != Cause::meeting && end->cause != Cause::boundary) continue;
        ++ends;
        ASSERT_GE(end->partner, 0);
        const Track& other = whole.tracks[static_cast<std::size_t>(end->partner)];
        expect_meeting(arm(), whole, *end, is_begin ? other.begin : other.end);
        const double step = is_begin ? -3e-7 : 3e-7;
        const int behind = count_at(arm(), whole.curve, end->s + step),
                  before = count_at(arm(), whole.curve, end->s - step);
        if (behind < 0 || before < 0) continue;
        EXPECT_LE(behind, before - 2) << end->s;
        EXPECT_EQ(end->cause == Cause::boundary, behind == 0) << end->s;
      }
  });
  EXPECT_GT(ends, 10);
}

/// True if a track of the way back is that one.
bool is_reversed(const Track& track, const Track& back, double end, const JointKinds<6>& revolute) {
  return std::abs(track.begin.s - (end - back.end.s)) < 1e-9 &&
         std::abs(track.end.s - (end - back.begin.s)) < 1e-9 &&
         difference(track.begin.q, back.end.q, revolute).norm() < 1e-6 &&
         difference(track.end.q, back.begin.q, revolute).norm() < 1e-6;
}

TEST_P(PathLaws, TheWayBackGivesTheSameMotions) {
  for_each_path(6, [&](const std::vector<Pose<double>>& samples) {
    const Whole there(arm(), samples);
    const Whole back(arm(), {samples.rbegin(), samples.rend()});
    EXPECT_EQ(there.record.tracks(), back.record.tracks());
    const std::vector<Track> others = back.found();
    for (const Track& track : there.found())
      EXPECT_TRUE(std::any_of(
          others.begin(), others.end(),
          [&](const Track& other) { return is_reversed(track, other, there.curve.end(), arm().revolute); }))
          << track.begin.s << " to " << track.end.s;
  });
}

TEST_P(PathLaws, MotionsOfTheHalvesJoin) {
  for_each_path(6, [&](const std::vector<Pose<double>>& samples) {
    const std::size_t half = samples.size() / 2;
    const double cut = static_cast<double>(half);
    const Whole whole(arm(), samples);
    const Whole first(arm(), {samples.begin(), samples.begin() + static_cast<long>(half) + 1});
    const Whole second(arm(), {samples.begin() + static_cast<long>(half), samples.end()});
    int joined = 0;
    for (const Track& one : first.found())
      for (const Track& two : second.found())
        joined += static_cast<int>(one.end.cause == Cause::path_end && two.begin.cause == Cause::path_end &&
                                   difference(one.end.q, two.begin.q, arm().revolute).norm() < 1e-9);
    const std::vector<Track> all = whole.found();
    const auto passing =
        std::count_if(all.begin(), all.end(), [&](const Track& track) { return is_alive(track, cut); });
    EXPECT_EQ(joined, passing);
    EXPECT_EQ(first.record.tracks() + second.record.tracks() - joined, whole.record.tracks());
  });
}

INSTANTIATE_TEST_SUITE_P(Arms, PathLaws, testing::ValuesIn(names_of_arms()),
                         [](const auto& arm_info) { return arm_info.param; });

}  // namespace
}  // namespace path_test
