// SPDX-License-Identifier: MIT
// Proofs that no other motion follows a path: all but what is next to singular poses is proven, and agrees
// with all solutions at dense places; a motion that is left out is never proven away; a motion between two
// places of the evaluation, which following alone misses, is found.
#include <gtest/gtest.h>
#include <qvgen/path/complete.h>
#include <qvgen/robots/cuspidal/certified.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace path_test {
namespace {

const AnyArm& cuspidal() { return arm_called("cuspidal").arm; }
const inverse::certified::Arm& cuspidal_bounds() {
  static const inverse::certified::Arm bounds = robots::cuspidal::arm_in_bounds();
  return bounds;
}

/// Stretches that are not proven, with the record as it is.
Stretches gaps_of(const Whole& whole) {
  Stretches gaps;
  Completer<AnyArm>(cuspidal(), cuspidal_bounds(), whole.curve, whole.record)
      .run(0, whole.curve.end(), [&](double from, double to) { gaps.emplace_back(from, to); });
  return gaps;
}

bool is_in(const Stretches& gaps, double s) {
  return std::any_of(gaps.begin(), gaps.end(),
                     [&](const auto& gap) { return gap.first <= s && s <= gap.second; });
}

double length_of(const Stretches& gaps) {
  double sum = 0;
  for (const auto& [from, to] : gaps) sum += to - from;
  return sum;
}

int alive_at(const Whole& whole, double s) {
  const auto tracks = whole.found();
  return static_cast<int>(std::count_if(tracks.begin(), tracks.end(), [&](const Track& track) {
    return track.begin.s <= s && s <= track.end.s;
  }));
}

/// The least singular value of the Jacobian of all solutions at a place; 0 without any.
double regularity_at(const Curve& curve, double s) {
  double least = 1;
  const auto found = cuspidal().solve(curve.at(s));
  for (const auto& row : found) {
    least = std::min(least, reference::smallest_singular_value(cuspidal().jacobian(row.q)));
  }
  return found.empty() ? 0 : least;
}

TEST(PathComplete, WhatIsNotNextToSingularPosesIsProvenAndAgreesWithDensePlaces) {
  constexpr std::array<Between, 4> ways{Between::screw, Between::spline, Between::straight, Between::blend};
  std::mt19937 random(6);
  double proven = 0, length = 0;
  for (int k = 0; k < path_count(4); ++k) {
    SCOPED_TRACE(k);
    const Whole whole(cuspidal(), random_path(cuspidal(), random, 3, 0.02), no_limits(),
                      ways.at(static_cast<std::size_t>(k) % 4), {}, 0.002);
    const Stretches gaps = gaps_of(whole);
    for (const auto& [from, to] : gaps) {
      const double nearest = std::min(regularity_at(whole.curve, from), regularity_at(whole.curve, to));
      EXPECT_LT(nearest, 0.05) << from << " to " << to;
    }
    proven += whole.curve.end() - length_of(gaps);
    length += whole.curve.end();
    for (int i = 0; i < 400; ++i) {
      const double s = whole.curve.end() * (i + 0.5) / 400;
      const auto found = cuspidal().solve(whole.curve.at(s));
      if (is_in(gaps, s) || found.status == Status::incomplete) continue;
      EXPECT_EQ(found.size(), alive_at(whole, s)) << s;
    }
  }
  EXPECT_GT(proven, length / 2);
}

TEST(PathComplete, AMotionThatIsLeftOutIsNotProvenAway) {
  std::mt19937 random(7);
  int left_out = 0;
  for (int k = 0; k < path_count(3); ++k) {
    SCOPED_TRACE(k);
    const Whole whole(cuspidal(), random_path(cuspidal(), random, 3, 0.01));
    const int track = k % std::max(1, whole.record.tracks());
    if (whole.record.tracks() == 0) continue;
    const Track full = whole.record.track(track);
    whole.record.track(track).begin.s = whole.record.track(track).end.s = -1;
    const Stretches gaps = gaps_of(whole);
    for (int i = 0; i <= 100; ++i)
      EXPECT_TRUE(is_in(gaps, full.begin.s + (full.end.s - full.begin.s) * i / 100)) << i;
    ++left_out;
  }
  EXPECT_GT(left_out, 1);
}

inverse::certified::CompleteEffort small_effort(long parts) {
  inverse::certified::CompleteEffort effort;
  effort.parts = parts;
  return effort;
}

/// Joints of one motion at both ends of a way.
using Row = std::array<std::array<double, 6>, 2>;

inverse::certified::Completeness proof_of(const Curve& curve, const std::vector<Row>& rows) {
  std::vector<const double(*)[6]> motions;
  for (const Row& row : rows) motions.push_back(reinterpret_cast<const double(*)[6]>(row.data()));
  const inverse::certified::Way way = proving::way_of(curve, 0);
  return inverse::certified::prove_complete(cuspidal_bounds(), {&way, 1, 0, 1},
                                            {motions.data(), static_cast<int>(motions.size())}, {},
                                            small_effort(60));
}

/// Nobody but the covering can tell here: there is no inverse kinematics to ask.
TEST(PathComplete, TheCoveringRefusesAMotionTooFew) {
  std::mt19937 random(9);
  int proven = 0;
  for (int k = 0; k < path_count(3); ++k) {
    SCOPED_TRACE(k);
    const Whole whole(cuspidal(), random_path(cuspidal(), random, 2, 0.001));
    std::vector<Row> rows;
    for (int track = 0; track < whole.record.tracks(); ++track) {
      Values from, to;
      if (!whole.record.at(0, track, from) || !whole.record.at(1, track, to)) continue;
      rows.emplace_back();
      std::copy(from.data(), from.data() + 6, rows.back()[0].begin());
      std::copy(to.data(), to.data() + 6, rows.back()[1].begin());
    }
    if (!proof_of(whole.curve, rows).is_proven()) continue;
    ++proven;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<Row> others = rows;
      others.erase(others.begin() + static_cast<long>(i));
      EXPECT_FALSE(proof_of(whole.curve, others).is_proven()) << i;
      others = rows;
      others[i][0][k % 6] += 1e-5;
      EXPECT_FALSE(proof_of(whole.curve, others).is_proven()) << i;
    }
  }
  EXPECT_GT(proven, 1);
}

/// Solutions at a place, -1 if not sure.
int count_at(const Curve& curve, double s) {
  const auto found = cuspidal().solve(curve.at(s));
  return found.status == Status::singular ? -1 : found.size();
}

/// Finds where the number of solutions changes between two places.
double change_between(const Curve& curve, double from, double to) {
  const int count = count_at(curve, from);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    (count_at(curve, middle) == count ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

/// A straight way of a hundredth past the singular pose of a meeting: along a random direction that leaves it
/// singular, and a little to a side.
std::vector<Pose<double>> way_past(const End& meeting, std::mt19937& random, double side) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Rate normal = reference::singular_values(cuspidal().jacobian(meeting.q)).u.col(5);
  Rate along;
  for (int i = 0; i < 6; ++i) along[i] = unit(random);
  along -= normal * normal.dot(along);
  along *= 0.01 / along.norm();
  const Pose<double> middle = cuspidal().forward(meeting.q);
  const auto moved = [&](double way) {
    const Rate rate = way * along + side * normal;
    return Pose<double>{from_rotation_vector<double>(rate.tail<3>()) * middle.orientation,
                        middle.position + rate.head<3>()};
  };
  return {moved(-0.37), moved(0.63)};
}

/// Ways on which more solutions exist near 0.37 than elsewhere.
std::vector<std::vector<Pose<double>>> ways_with_excursions(std::size_t most) {
  std::mt19937 random(8);
  std::vector<std::vector<Pose<double>>> ways;
  for (int k = 0; k < 60; ++k) {
    const Whole whole(cuspidal(), random_path(cuspidal(), random, 8, 0.5));
    for (const Track& track : whole.found())
      for (const double side : {5e-8, -5e-8}) {
        if (track.end.cause != Cause::meeting && track.end.cause != Cause::boundary) continue;
        const auto way = way_past(track.end, random, side);
        const Curve curve(way.data(), way.size());
        const int begin = count_at(curve, 0.01), before = count_at(curve, 0.3),
                  inside = count_at(curve, 0.37), behind = count_at(curve, 0.44), end = count_at(curve, 0.99);
        if (before < 0 || begin != before || before != behind || end != behind || inside <= before) continue;
        ways.push_back(way);
        if (ways.size() == most) return ways;
      }
  }
  return ways;
}

TEST(PathComplete, AMotionBetweenTwoPlacesIsFound) {
  int hidden = 0;
  const int count = std::min(path_count(1), 2);
  for (const auto& way : ways_with_excursions(static_cast<std::size_t>(count))) {
    SCOPED_TRACE(hidden);
    Whole whole(cuspidal(), way);
    const int before = whole.record.tracks();
    std::vector<double> extra;
    static_cast<void>(prove_complete(
        cuspidal(), cuspidal_bounds(), whole.curve, whole.record, extra,
        [&] {
          Options options;
          options.extra = extra.data();
          options.extra_count = extra.size();
          whole.follow(cuspidal(), options);
        },
        small_effort(20)));
    const double from = change_between(whole.curve, 0.3, 0.37), to = change_between(whole.curve, 0.44, 0.37);
    const int more = count_at(whole.curve, 0.37) - count_at(whole.curve, 0.3);
    const auto tracks = whole.found();
    EXPECT_EQ(std::count_if(tracks.begin(), tracks.end(),
                            [&](const Track& track) {
                              return std::abs(track.begin.s - from) < 1e-6 &&
                                     std::abs(track.end.s - to) < 1e-6;
                            }),
              more)
        << from << " to " << to;
    hidden += static_cast<int>(whole.record.tracks() == before + more && !extra.empty());
  }
  EXPECT_EQ(hidden, count);
}

}  // namespace
}  // namespace path_test
