// SPDX-License-Identifier: MIT
// Sets of orientations and directions are spread evenly whatever their size: no two are near each other, none
// is far from all. Random sets, which the same bounds are asked of, fail both.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <qvgen/map/even.h>

namespace qvgen::map {
namespace {

using Orientations = std::vector<Eigen::Vector4d>;

constexpr double pi = 3.14159265358979323846;

/// The turn from one to the other, rad.
double angle(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  return 2 * std::acos(std::min(1.0, std::abs(a.dot(b))));
}

Orientations even(std::size_t count) {
  Orientations all;
  for (std::size_t i = 0; i < count; ++i) {
    const auto q = even_orientation(i, count);
    all.emplace_back(q[0], q[1], q[2], q[3]);
  }
  return all;
}

Orientations random(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Orientations all;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector4d q;
    for (int n = 0; n < 4; ++n) q[n] = normal(engine);
    all.push_back(q.normalized());
  }
  return all;
}

double nearest(const Orientations& set, const Eigen::Vector4d& q, std::size_t except) {
  double least = pi;
  for (std::size_t i = 0; i < set.size(); ++i)
    if (i != except) least = std::min(least, angle(set[i], q));
  return least;
}

/// The edge of a cube of the volume that each has: all orientations are 8 pi^2 of it, rad^3.
double spacing(std::size_t count) { return std::cbrt(8 * pi * pi / static_cast<double>(count)); }

double separation(const Orientations& set) {
  double least = pi;
  for (std::size_t i = 0; i < set.size(); ++i) least = std::min(least, nearest(set, set[i], i));
  return least / spacing(set.size());
}

/// The largest gap, by random orientations.
double covering(const Orientations& set) {
  double most = 0;
  for (const auto& q : random(3000, 7)) most = std::max(most, nearest(set, q, set.size()));
  return most / spacing(set.size());
}

constexpr double least_separation = 0.5, most_covering = 1.05;

TEST(EvenOrientations, AreFarFromEachOtherAndLeaveNoGap) {
  for (const std::size_t count : {20U, 48U, 101U, 256U, 777U, 1000U}) {
    const Orientations set = even(count);
    for (const auto& q : set) EXPECT_NEAR(q.norm(), 1, 1e-15);
    EXPECT_GT(separation(set), least_separation) << count;
    EXPECT_LT(covering(set), most_covering) << count;
  }
}

TEST(EvenOrientations, AreFarFromEachOtherWhateverTheirNumber) {
  for (std::size_t count = 2; count <= 150; ++count)
    EXPECT_GT(separation(even(count)), least_separation) << count;
}

TEST(EvenOrientations, AreMoreEvenThanRandomOnes) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    EXPECT_LT(separation(random(256, seed)), least_separation);
    EXPECT_GT(covering(random(256, seed)), most_covering);
  }
}

TEST(EvenOrientations, HaveTheAverageOfAllRotations) {
  // The mean of R is zero, and that of each R_ij^2 a third.
  for (const std::size_t count : {100U, 1000U}) {
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero(), square = mean;
    for (const auto& q : even(count)) {
      const Eigen::Matrix3d r = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      mean += r / static_cast<double>(count);
      square += r.cwiseProduct(r) / static_cast<double>(count);
    }
    EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4.0 / static_cast<double>(count)) << mean;
    EXPECT_LT((square.array() - 1.0 / 3).abs().maxCoeff(), 4.0 / static_cast<double>(count)) << square;
  }
}

TEST(EvenDirections, AreFarFromEachOtherAndEven) {
  for (const std::size_t count : {2U, 10U, 99U, 1000U}) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double least = 2;
    std::vector<Eigen::Vector3d> all;
    for (std::size_t i = 0; i < count; ++i) {
      const auto d = even_direction(i, count);
      const Eigen::Vector3d v(d[0], d[1], d[2]);
      EXPECT_NEAR(v.norm(), 1, 1e-15);
      for (const auto& other : all) least = std::min(least, (v - other).norm());
      mean += v / static_cast<double>(count);
      all.push_back(v);
    }
    // Each has an area of 4 pi / count.
    EXPECT_GT(least, 0.7 * std::sqrt(4 * pi / static_cast<double>(count))) << count;
    if (count > 9) {
      EXPECT_LT(mean.norm(), 2.0 / static_cast<double>(count)) << count;
    }
  }
}

TEST(EvenValues, AreTheMiddlesOfEqualPieces) {
  EXPECT_DOUBLE_EQ(even_value(0, 4, -1, 3), -0.5);
  EXPECT_DOUBLE_EQ(even_value(3, 4, -1, 3), 2.5);
  EXPECT_DOUBLE_EQ(even_value(0, 1, -1, 3), 1);
  EXPECT_DOUBLE_EQ(even_angle(1, 4), pi / 2);
}

}  // namespace
}  // namespace qvgen::map
