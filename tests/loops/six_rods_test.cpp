// SPDX-License-Identifier: MIT
// All places of platforms on six rods: of no special shape, with their ends in planes, and octahedral ones
// whose rods share joints. What is found is held against sampled places, against Newton's steps from random
// starts on rotation matrices, and against the platform of Dietmaier (1998), all of whose 40 places are real.
#include "verify/loops/six_rods.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <qvgen/inverse/six_rods/places.h>

namespace qvgen::test {
namespace {

namespace rods = qvgen::inverse::six_rods;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Lengths = std::array<double, 6>;
using Ends = rods::Ends<double>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int inputs = QVGEN_LOOP_STARTS < 1000 ? 80 : 1000;
constexpr int share_with_starts = 40;  // every 40th input is solved by Newton's steps as well

Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// A shape with its name for messages.
struct Shape {
  const char* name;
  Ends ends;
};

double uniform(std::mt19937& random, double most = 1) {
  return std::uniform_real_distribution<double>(-most, most)(random);
}

Ends random_ends(std::mt19937& random) {
  Ends ends;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      ends.base[i][k] = uniform(random);
      ends.platform[i][k] = 0.3 + 0.6 * uniform(random);
    }
  return ends;
}

Ends in_planes(Ends ends) {
  for (std::size_t i = 0; i < 6; ++i) ends.base[i][2] = ends.platform[i][2] = 0.1;
  return ends;
}

Ends octahedral(Ends ends) {
  for (std::size_t i = 0; i < 6; ++i) ends.base[i] = ends.base[i / 2 * 2];
  for (std::size_t i = 0; i < 6; i += 2) ends.platform[(i + 2) % 6] = ends.platform[i + 1];
  return ends;
}

template <int count>
rods::Start<count> start_of(const verify::CountedPlaces& counted) {
  EXPECT_EQ(counted.points.size(), static_cast<std::size_t>(count));
  rods::Start<count> start{counted.unit,
                           counted.base_centre,
                           counted.platform_centre,
                           counted.ends,
                           counted.squares,
                           counted.patch,
                           {}};
  std::copy_n(counted.points.begin(), std::min<std::size_t>(counted.points.size(), count),
              start.points.begin());
  return start;
}

Lengths lengths_of(const Ends& ends, const Isometry3d& pose) {
  Lengths lengths;
  for (std::size_t i = 0; i < 6; ++i)
    lengths[i] = (pose * vector(ends.platform[i]) - vector(ends.base[i])).norm();
  return lengths;
}

Isometry3d random_pose(std::mt19937& random) {
  Isometry3d pose(Eigen::Translation3d(uniform(random), uniform(random), uniform(random)));
  Eigen::Vector4d turn;
  do {
    for (double& each : turn) each = uniform(random);
  } while (turn.norm() > 1 || turn.norm() < 0.1);
  pose.rotate(Eigen::Quaterniond(turn.normalized()));
  return pose;
}

Isometry3d pose_of(const rods::Place& place) {
  Isometry3d pose(Eigen::Translation3d(vector(place.position)));
  pose.rotate(Eigen::Quaterniond(place.turn[0], place.turn[1], place.turn[2], place.turn[3]));
  return pose;
}

double gap_of(const Ends& ends, const Isometry3d& pose, const Lengths& lengths) {
  const Lengths found = lengths_of(ends, pose);
  double most = 0;
  for (std::size_t i = 0; i < 6; ++i) most = std::max(most, std::abs(found[i] - lengths[i]));
  return most;
}

template <int count>
bool has(const rods::Places<count>& places, const Isometry3d& pose, double within) {
  for (int i = 0; i < places.size; ++i)
    if ((pose_of(places.rows[static_cast<std::size_t>(i)]).matrix() - pose.matrix()).norm() < within)
      return true;
  return false;
}

/// Derivatives of half the squared lengths by a twist about the base's origin.
Eigen::Matrix<double, 6, 6> derivatives(const Ends& ends, const Isometry3d& pose) {
  Eigen::Matrix<double, 6, 6> rows;
  for (int i = 0; i < 6; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vector3d end = pose * vector(ends.platform[k]), rod = end - vector(ends.base[k]);
    rows.row(i) << rod.transpose(), end.cross(rod).transpose();
  }
  return rows;
}

/// Newton's steps on rotation matrices; true if they end where the lengths are met.
bool solve_next_to(const Ends& ends, const Lengths& lengths, Isometry3d& pose) {
  for (int k = 0; k < 40; ++k) {
    const Lengths found = lengths_of(ends, pose);
    Vector6 gaps;
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      gaps[i] = 0.5 * (lengths[at] * lengths[at] - found[at] * found[at]);
    }
    Vector6 twist = derivatives(ends, pose).partialPivLu().solve(gaps);
    if (!twist.allFinite()) return false;
    if (twist.norm() > 1) twist.normalize();
    const Vector3d turn = twist.tail<3>();
    const double angle = turn.norm();
    Isometry3d step(Eigen::Translation3d(twist.head<3>()));
    if (angle > 0) step.rotate(Eigen::AngleAxisd(angle, turn / angle));
    pose = step * pose;
    if (twist.norm() < 1e-13) break;
  }
  return gap_of(ends, pose, lengths) < 1e-11;
}

template <int count>
void expect_no_other(const Shape& shape, const Lengths& lengths, const rods::Places<count>& places,
                     std::mt19937& random) {
  int met = 0;
  for (int k = 0; k < QVGEN_LOOP_STARTS; ++k) {
    Isometry3d pose = random_pose(random);
    if (!solve_next_to(shape.ends, lengths, pose)) continue;
    ++met;
    EXPECT_TRUE(has(places, pose, 1e-6)) << shape.name << ": Newton's steps found another place";
  }
  EXPECT_GT(met, 0) << shape.name;
}

template <int count>
void expect_all_places(const Shape& shape, const rods::Start<count>& start) {
  std::mt19937 random(11);
  for (int n = 0; n < inputs; ++n) {
    const Isometry3d pose = random_pose(random);
    const Lengths lengths = lengths_of(shape.ends, pose);
    const auto places = rods::find_places(start, lengths);
    ASSERT_TRUE(places.complete) << shape.name << " " << n << ": " << places.proven;
    ASSERT_EQ(places.proven, count);
    EXPECT_EQ(places.size % 2, 0);  // others are pairs of conjugates
    EXPECT_TRUE(has(places, pose, 1e-9)) << shape.name << " " << n;
    for (int i = 0; i < places.size; ++i) {
      const rods::Place& place = places.rows[static_cast<std::size_t>(i)];
      EXPECT_LT(gap_of(shape.ends, pose_of(place), lengths), 1e-13);
      EXPECT_FALSE(place.meets);
    }
    if (n % share_with_starts == 0) expect_no_other(shape, lengths, places, random);
  }
}

Ends ends_of_tests() {
  std::mt19937 random(4);
  return random_ends(random);
}

/// Paths of that general platform, which is counted once.
const rods::Start<40>& general() {
  static const rods::Start<40> start = start_of<40>(verify::count_places(ends_of_tests()));
  return start;
}

TEST(SixRods, NoPlaceIsMissingOfAGeneralPlatform) {
  expect_all_places<40>({"general", ends_of_tests()}, general());
}
TEST(SixRods, NoPlaceIsMissingOfAPlanarPlatform) {
  const Ends ends = in_planes(ends_of_tests());
  expect_all_places({"planar", ends}, start_of<40>(verify::count_places(ends)));
}
TEST(SixRods, NoPlaceIsMissingOfAnOctahedron) {
  const Ends ends = octahedral(ends_of_tests());
  expect_all_places({"octahedral", ends}, start_of<16>(verify::count_places(ends)));
}

/// P. Dietmaier, "The Stewart-Gough platform of general geometry can have 40 real postures", 1998.
Ends of_dietmaier() {
  return {{{{0, 0, 0},
            {1.107915, 0, 0},
            {0.549094, 0.756063, 0},
            {0.735077, -0.223935, 0.525991},
            {0.514188, -0.526063, -0.368418},
            {0.590473, 0.094733, -0.205018}}},
          {{{0, 0, 0},
            {0.542805, 0, 0},
            {0.956919, -0.528915, 0},
            {0.665885, -0.353482, 1.402538},
            {0.478359, 1.158742, 0.107672},
            {-0.137087, -0.235121, 0.353913}}}};
}

TEST(SixRods, AllFortyPlacesOfDietmaiersPlatformAreReal) {
  const Lengths lengths = {1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071};
  const auto start = start_of<40>(verify::count_places(of_dietmaier()));
  const auto places = rods::find_places(start, lengths);
  EXPECT_TRUE(places.complete);
  ASSERT_EQ(places.size, 40);
  for (int i = 0; i < places.size; ++i)
    EXPECT_LT(gap_of(of_dietmaier(), pose_of(places.rows[static_cast<std::size_t>(i)]), lengths), 1e-13);
}

/// A pose between two others at which the rods do not hold the platform.
Isometry3d singular_pose(const Ends& ends, std::mt19937& random) {
  for (;;) {
    const Isometry3d from = random_pose(random), to = random_pose(random);
    const auto at = [&](double s) {
      Isometry3d pose(Eigen::Translation3d((1 - s) * from.translation() + s * to.translation()));
      pose.rotate(Eigen::Quaterniond(from.linear()).slerp(s, Eigen::Quaterniond(to.linear())));
      return pose;
    };
    const auto side = [&](double s) { return derivatives(ends, at(s)).determinant() > 0; };
    if (side(0) == side(1)) continue;
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) (side(0.5 * (low + high)) == side(0) ? low : high) = 0.5 * (low + high);
    return at(low);
  }
}

TEST(SixRods, SaysWherePlacesMeet) {
  const Ends ends = ends_of_tests();
  const auto& start = general();
  std::mt19937 random(8);
  for (int n = 0; n < 10; ++n) {
    const Isometry3d pose = singular_pose(ends, random);
    const Lengths lengths = lengths_of(ends, pose);
    const auto places = rods::find_places(start, lengths);
    EXPECT_FALSE(places.complete);
    EXPECT_TRUE(has(places, pose, 1e-5)) << n;
    for (int i = 0; i < places.size; ++i) {
      const rods::Place& place = places.rows[static_cast<std::size_t>(i)];
      EXPECT_LT(gap_of(ends, pose_of(place), lengths), 1e-11);
      if ((pose_of(place).matrix() - pose.matrix()).norm() < 1e-5) {
        EXPECT_TRUE(place.meets) << n;
      }
    }
  }
}

TEST(SixRods, AWrongTableIsNeverComplete) {
  const Ends ends = ends_of_tests();
  std::mt19937 random(9);
  const Lengths lengths = lengths_of(ends, random_pose(random));
  const auto& start = general();
  ASSERT_TRUE(rods::find_places(start, lengths).complete);
  auto doubled = start, moved = start;
  doubled.points[3] = doubled.points[17];
  for (auto& each : moved.points[5]) each.re += 0.3;
  EXPECT_EQ(rods::find_places(doubled, lengths).proven, 39);
  EXPECT_FALSE(rods::find_places(doubled, lengths).complete);
  EXPECT_FALSE(rods::find_places(moved, lengths).complete);
  auto elsewhere = start;
  elsewhere.squares[0].im += 0.5;
  EXPECT_FALSE(rods::find_places(elsewhere, lengths).complete);
}

TEST(SixRods, LengthsThatCannotMeetHaveNoPlace) {
  const auto& start = general();
  const auto far = rods::find_places(start, {40, 1, 1, 1, 1, 1});
  EXPECT_TRUE(far.complete);
  EXPECT_EQ(far.size, 0);
  const auto short_ones = rods::find_places(start, {0.01, 0.01, 0.01, 0.01, 0.01, 0.01});
  EXPECT_TRUE(short_ones.complete);
  EXPECT_EQ(short_ones.size, 0);
}

TEST(SixRods, NumbersThatAreNoneEnd) {
  const auto& start = general();
  for (const double bad : {std::nan(""), HUGE_VAL, 1e200}) {
    const auto places = rods::find_places(start, {1, 1, bad, 1, 1, 1});
    EXPECT_EQ(places.size, 0) << bad;
  }
  EXPECT_FALSE(rods::find_places(start, {1, 1, std::nan(""), 1, 1, 1}).complete);
}

TEST(SixRods, APlatformThatMovesThoughRodsAreHeldIsRefused) {
  Ends ends;  // both on circles, at the same angles: Duporcq's case of similar hexagons on a conic
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = static_cast<double>(i) + 0.1 * static_cast<double>(i * i % 5);
    ends.base[i] = {std::cos(angle), std::sin(angle), 0};
    ends.platform[i] = {0.6 * std::cos(angle), 0.6 * std::sin(angle), 0};
  }
  EXPECT_THROW(verify::count_places(ends), std::domain_error);
}

TEST(SixRods, CountsAlike) {
  const auto again = verify::count_places(ends_of_tests());
  for (std::size_t i = 0; i < again.points.size(); ++i)
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_EQ(again.points[i][k].re, general().points[i][k].re);
      EXPECT_EQ(again.points[i][k].im, general().points[i][k].im);
    }
}

}  // namespace
}  // namespace qvgen::test
