// SPDX-License-Identifier: MIT
// Proofs of motions: away from singular poses every motion is proven whole, stretches that are not proven lie
// next to singular ones, and a claim that is wrong - joints that are off, a jump to another branch, a tool
// that takes another way - is never proven.
#include <gtest/gtest.h>
#include <qvgen/path/prove.h>
#include <qvgen/robots/cuspidal/certified.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace path_test {
namespace {

const AnyArm& arm() { return arm_called("cuspidal").arm; }
const inverse::certified::Arm& bounds() {
  static const inverse::certified::Arm bounds = robots::cuspidal::arm_in_bounds();
  return bounds;
}

struct Gaps {
  std::vector<std::pair<double, double>> rows;
  Proven proven;
};

Gaps proven(const Whole& whole, const Motion& motion) {
  Gaps gaps;
  gaps.proven = prove(bounds(), whole.curve, whole.record, motion,
                      [&](double from, double to) { gaps.rows.emplace_back(from, to); });
  return gaps;
}

Motion motion_on(const Whole& whole, int number) {
  Motion motion;
  motion.track = number;
  motion.begin = whole.record.track(number).begin;
  motion.end = whole.record.track(number).end;
  return motion;
}

/// The least singular value of the Jacobian at joints followed by small steps from a sample.
double regularity(const Whole& whole, int track, double s) {
  Values q;
  const auto sample = static_cast<std::size_t>(s + 0.5);
  if (!whole.record.at(sample, track, q)) return 0;
  const auto found = arm().solve(whole.curve.at(s));
  const Nearest nearest = Nearest::of(found, q, arm().revolute);
  if (nearest.row < 0) return 0;
  return reference::smallest_singular_value(arm().jacobian(found[nearest.row].q));
}

/// All ways between samples, one after the other.
Between way_between(int k) {
  constexpr std::array<Between, 4> ways{Between::screw, Between::straight, Between::spline, Between::blend};
  return ways.at(static_cast<std::size_t>(k) % 4);
}

TEST(PathProof, OnlyWhatIsNextToSingularPosesIsNotProven) {
  std::mt19937 random(3);
  int whole_ones = 0, gaps = 0;
  for (int k = 0; k < path_count(4); ++k) {
    SCOPED_TRACE(k);
    const Whole whole(arm(), random_path(arm(), random, 12, k % 2 == 0 ? 0.2 : 0.8), no_limits(),
                      way_between(k), {}, 0.005);
    for (int track = 0; track < whole.record.tracks(); ++track) {
      const Motion motion = motion_on(whole, track);
      const Gaps result = proven(whole, motion);
      EXPECT_EQ(result.proven.is_whole, result.rows.empty());
      whole_ones += static_cast<int>(result.proven.is_whole);
      for (const auto& [from, to] : result.rows) {
        ++gaps;
        EXPECT_LE(motion.begin.s, from);
        EXPECT_LT(from, to);
        EXPECT_LE(to, motion.end.s);
        const bool is_at_an_end = (from == motion.begin.s && motion.begin.cause != Cause::path_end) ||
                                  (to == motion.end.s && motion.end.cause != Cause::path_end);
        if (is_at_an_end) {
          EXPECT_LT(to - from, 1e-2);
        } else {
          EXPECT_LT(regularity(whole, track, 0.5 * (from + to)), 2e-3) << from << " " << to;
        }
      }
    }
  }
  EXPECT_GT(whole_ones, 8);
  EXPECT_GT(gaps, 2);
}

/// The ends of a way, each with all solutions there.
struct Between2 {
  Pose<double> a, b;
  Solutions<6, 16> at_a, at_b;
  inverse::certified::Way way;
};

inverse::certified::TubeProof tube(const Between2& way, const Values& from, const Values& to) {
  return inverse::certified::prove_tube(bounds(), way.way, proving::end_of(0, from), proving::end_of(1, to),
                                        200);
}

TEST(PathProof, WrongClaimsAreNotProven) {
  std::mt19937 random(4);
  int right = 0, wrong = 0;
  for (int k = 0; k < path_count(4); ++k) {
    const auto samples = random_path(arm(), random, 3, 0.1);
    const Curve curve(samples.data(), 3, way_between(k), 0.01);
    const Between2 way{curve.at(0), curve.at(1), arm().solve(curve.at(0)), arm().solve(curve.at(1)),
                       proving::way_of(curve, 0)};
    for (const auto& from : way.at_a)
      for (const auto& to : way.at_b) {
        const Values goal = from.q + difference(to.q, from.q, arm().revolute);
        const bool is_proven = tube(way, from.q, goal).is_proven();
        // Small steps from the start decide which row it becomes.
        Values q = from.q;
        for (int i = 1; i <= 200; ++i) {
          const auto found = arm().solve(curve.at(i / 200.0));
          const Nearest nearest = Nearest::of(found, q, arm().revolute);
          if (nearest.row >= 0) q += difference(found[nearest.row].q, q, arm().revolute);
        }
        const bool is_right = (q - goal).norm() < 1e-6;
        right += static_cast<int>(is_proven);
        if (!is_right) {
          ++wrong;
          EXPECT_FALSE(is_proven) << k << ": " << from.q.transpose() << " to " << goal.transpose();
        }
        if (!is_proven) continue;
        Values off = goal;
        off[k % 6] += 1e-5;
        EXPECT_FALSE(tube(way, from.q, off).is_proven());
        Between2 other = way;
        other.way.from.position.x() += 1e-5;
        EXPECT_FALSE(tube(other, from.q, goal).is_proven());
      }
  }
  EXPECT_GT(right, 6);
  EXPECT_GT(wrong, 30);
}

/// The joints in the tube of a bent way are those of its poses, not of the straight ones or of others.
TEST(PathProof, TubesHoldTheJointsOfBentWays) {
  std::mt19937 random(6);
  int seen = 0, missed = 0;
  for (int k = 0; k < 16; ++k) {
    auto samples = random_path(arm(), random, 3, 0.2);
    samples[2].position += Vector3<double>(0.03, -0.02, 0.04);
    const Curve curve(samples.data(), 3, k % 2 == 0 ? Between::spline : Between::blend, 0.05);
    const Curve straight(samples.data(), 3);
    const auto start = arm().solve(curve.at(0.75));
    for (const auto& row : start) {
      Values q = row.q;
      const auto next_on = [&](const Curve& way, double u) {
        const auto found = arm().solve(way.at(u));
        const Nearest nearest = Nearest::of(found, q, arm().revolute);
        return nearest.row < 0 ? q : Values(q + difference(found[nearest.row].q, q, arm().revolute));
      };
      Values low = q, high = q;
      double off = 0;
      for (int i = 0; i <= 40; ++i) {
        const double u = 0.75 + 0.002 * i;
        off = std::max(off, (next_on(straight, u) - next_on(curve, u)).cwiseAbs().maxCoeff());
        q = next_on(curve, u);
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
      }
      const auto proof = inverse::certified::prove_tube(
          bounds(), proving::way_of(curve, 0), proving::end_of(0.75, row.q), proving::end_of(0.83, q), 400);
      if (!proof.is_proven()) continue;
      ++seen;
      for (int i = 0; i < 6; ++i) {
        EXPECT_LE(proof.range[static_cast<std::size_t>(i)].lower, low[i]);
        EXPECT_GE(proof.range[static_cast<std::size_t>(i)].upper, high[i]);
      }
      // Such a claim about the straight way is wrong.
      missed +=
          static_cast<int>(off > 1e-6 && !inverse::certified::prove_tube(
                                              bounds(), proving::way_of(straight, 0),
                                              proving::end_of(0.75, row.q), proving::end_of(0.83, q), 400)
                                              .is_proven());
    }
  }
  EXPECT_GT(seen, 10);
  EXPECT_GT(missed, 5);
}

TEST(PathProof, BadNumbersAreNotProven) {
  std::mt19937 random(5);
  const auto samples = random_path(arm(), random, 2, 0.05);
  const Curve curve(samples.data(), 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Between2 way{samples[0], samples[1], arm().solve(samples[0]), {}, proving::way_of(curve, 0)};
  ASSERT_FALSE(way.at_a.empty());
  const Values q = way.at_a[0].q;
  for (const double bad : {nan, std::numeric_limits<double>::infinity(), 1e300}) {
    EXPECT_FALSE(tube(way, Values::Constant(bad), q).is_proven());
    Between2 other = way;
    other.way.move.x() = bad;
    EXPECT_FALSE(tube(other, q, q).is_proven());
    other = way;
    other.way.turn.x() = bad;
    EXPECT_FALSE(tube(other, q, q).is_proven());
    other = way;
    other.way.start = way.way.from;
    other.way.bend.kind = inverse::certified::WayBend::Kind::corners;
    other.way.bend.begin = bad;
    EXPECT_FALSE(tube(other, q, q).is_proven());
    other.way.bend.begin = 0.5;
    other.way.bend.a[4] = bad;
    EXPECT_FALSE(tube(other, q, q).is_proven());
  }
}

}  // namespace
}  // namespace path_test
