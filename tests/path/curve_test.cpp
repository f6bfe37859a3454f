// SPDX-License-Identifier: MIT
// The path between samples: ends are met, rates are differences, a screw is a rigid turn about a fixed line,
// splines and blends leave no corner.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/path/curve.h>

namespace path_test {
namespace {

using namespace qvgen;
using namespace qvgen::path;

Pose<double> random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return {Quaternion<double>(unit(random), unit(random), unit(random), unit(random)).normalized(),
          {unit(random), unit(random), unit(random)}};
}

class CurveBetween : public testing::TestWithParam<Between> {};

TEST_P(CurveBetween, EndsAreTheSamplesWhateverTheSign) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<Pose<double>> samples{random_pose(random), random_pose(random), random_pose(random)};
    samples[1].orientation.coeffs() *= i % 2 == 0 ? 1 : -1;
    const Curve curve(samples.data(), samples.size(), GetParam());
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(linear_distance(curve.at(static_cast<double>(k)), samples[k]), 1e-12);
      EXPECT_LT(angular_distance(curve.at(static_cast<double>(k)), samples[k]), 1e-12);
    }
    const double before = 1 - 1e-12;
    EXPECT_LT(linear_distance(curve.at(before), samples[1]), 1e-9);
  }
}

TEST_P(CurveBetween, RatesAreDifferences) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const Piece piece(random_pose(random), random_pose(random), GetParam());
    const double u = 0.3, h = 1e-6;
    const Pose<double> before = piece.at(u - h), behind = piece.at(u + h);
    Rate difference;
    difference << (behind.position - before.position) / (2 * h),
        rotation_vector<double>(behind.orientation * before.orientation.conjugate()) / (2 * h);
    EXPECT_LT((difference - piece.rate(u)).norm(), 1e-7 * (1 + piece.rate(u).norm()));
  }
}

TEST(Curve, AScrewKeepsItsAxisAndItsPitch) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const Piece piece(random_pose(random), random_pose(random), Between::screw);
    const Pose<double> step = piece.at(0.5) * piece.at(0.25).inverse();
    const Pose<double> next = piece.at(0.75) * piece.at(0.5).inverse();
    EXPECT_LT(linear_distance(step, next), 1e-11);
    EXPECT_LT(angular_distance(step, next), 1e-11);
  }
}

TEST(Curve, AStraightPieceIsStraightAndEven) {
  std::mt19937 random(4);
  const Pose<double> a = random_pose(random), b = random_pose(random);
  const Piece piece(a, b, Between::straight);
  EXPECT_LT((piece.at(0.25).position - (0.75 * a.position + 0.25 * b.position)).norm(), 1e-15);
  EXPECT_NEAR(angular_distance(piece.at(0.25), a), 0.25 * angular_distance(a, b), 1e-12);
}

/// Rate of a curve by differences on one side of a place.
Rate rate_beside(const Curve& curve, double s, double side) {
  const double h = 1e-6 * side;
  const Pose<double> here = curve.at(s), there = curve.at(s + h), far = curve.at(s + 2 * h);
  const auto way = [&](const Pose<double>& to) {
    Rate rate;
    rate << to.position - here.position,
        rotation_vector<double>(to.orientation * here.orientation.conjugate());
    return rate;
  };
  return (4 * way(there) - way(far)) / (2 * h);
}

class BentCurve : public testing::TestWithParam<Between> {};

TEST_P(BentCurve, NothingJumpsAndNoCornerIsLeft) {
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    std::vector<Pose<double>> samples;
    for (int k = 0; k < 6; ++k) samples.push_back(random_pose(random));
    samples[3] = samples[2];  // a rest: corners are allowed at both of them
    const Curve curve(samples.data(), samples.size(), GetParam(), 0.1);
    for (const double s : {0.3, 0.7, 0.97, 1.0, 1.04, 1.5, 1.96, 3.2, 4.0, 4.6}) {
      const std::size_t piece = curve.piece_at(s);
      const Rate told = curve.piece(piece).rate(s - static_cast<double>(piece));
      for (const double side : {-1.0, 1.0})
        EXPECT_LT((rate_beside(curve, s, side) - told).norm(), 1e-5 * (1 + told.norm())) << s << " " << side;
    }
    for (std::size_t k = 0; k < 5; ++k) {
      const Pose<double> end = curve.piece(k).at(1);
      EXPECT_LT(linear_distance(end, curve.at(static_cast<double>(k + 1))), 1e-12);
      EXPECT_LT(angular_distance(end, curve.at(static_cast<double>(k + 1))), 1e-12);
    }
    for (const std::size_t end : {std::size_t{0}, std::size_t{2}, std::size_t{5}})
      EXPECT_LT(linear_distance(curve.at(static_cast<double>(end)), samples[end]), 1e-12);
  }
}

TEST_P(BentCurve, LengthsAreBounds) {
  std::mt19937 random(6);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Pose<double>> samples{random_pose(random), random_pose(random), random_pose(random)};
    const Curve curve(samples.data(), samples.size(), GetParam(), 0.1);
    for (std::size_t k = 0; k < 2; ++k) {
      const Piece piece = curve.piece(k);
      double way = 0, turn = 0;
      for (int n = 0; n < 100; ++n) {
        way += linear_distance(piece.at(0.01 * n), piece.at(0.01 * (n + 1)));
        turn += angular_distance(piece.at(0.01 * n), piece.at(0.01 * (n + 1)));
      }
      EXPECT_LT(way, piece.distance() * (1 + 1e-9));
      EXPECT_LT(turn, piece.angle() * (1 + 1e-9));
    }
  }
}

TEST(Curve, ASplinePassesItsSamplesAndEvenOnesAreStraight) {
  std::mt19937 random(7);
  std::vector<Pose<double>> samples;
  for (int k = 0; k < 5; ++k) samples.push_back(random_pose(random));
  const Curve spline(samples.data(), samples.size(), Between::spline);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LT(linear_distance(spline.at(static_cast<double>(k)), samples[k]), 1e-12);
    EXPECT_LT(angular_distance(spline.at(static_cast<double>(k)), samples[k]), 1e-12);
  }
  for (std::size_t k = 0; k < 5; ++k)
    samples[k] = {
        from_rotation_vector<double>(0.3 * static_cast<double>(k) * Vector3<double>(1, 2, 3).normalized()),
        0.1 * static_cast<double>(k) * Vector3<double>(1, 0, 1)};
  const Curve even(samples.data(), samples.size(), Between::spline), line(samples.data(), samples.size());
  for (const double s : {0.2, 1.7, 2.5, 3.9}) {
    EXPECT_LT(linear_distance(even.at(s), line.at(s)), 1e-12);
    EXPECT_LT(angular_distance(even.at(s), line.at(s)), 1e-12);
  }
}

/// Outside the rounded corners a blend is the straight line; within, the corner is a quarter of the change of
/// the rate on the share away.
TEST(Curve, ABlendLeavesTheLinesAtItsRadius) {
  std::vector<Pose<double>> samples(3);
  samples[1].position = {0.2, 0, 0};
  samples[2].position = {0.2, 0.1, 0};
  const Curve blend(samples.data(), 3, Between::blend, 0.02), line(samples.data(), 3);
  for (const double s : {0.0, 0.5, 0.899, 1.101, 1.6, 2.0})
    EXPECT_LT(linear_distance(blend.at(s), line.at(s)), 1e-15);
  EXPECT_NEAR(linear_distance(blend.at(1), samples[1]), std::hypot(0.2, 0.1) * 0.1 / 4, 1e-15);
  EXPECT_GT(linear_distance(blend.at(0.95), line.at(0.95)), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Both, BentCurve, testing::Values(Between::spline, Between::blend));
INSTANTIATE_TEST_SUITE_P(Both, CurveBetween, testing::Values(Between::straight, Between::screw));

}  // namespace
}  // namespace path_test
