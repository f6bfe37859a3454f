// SPDX-License-Identifier: MIT
// The path between samples: ends are met, rates are differences, a screw is a rigid turn about a fixed line.
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

INSTANTIATE_TEST_SUITE_P(Both, CurveBetween, testing::Values(Between::straight, Between::screw));

}  // namespace
}  // namespace path_test
