// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <qvgen/pack.h>

namespace {

using qvgen::Pack;

void expect_lanes(const Pack& pack, double a, double b, double c, double d) {
  EXPECT_EQ(pack[0], a);
  EXPECT_EQ(pack[1], b);
  EXPECT_EQ(pack[2], c);
  EXPECT_EQ(pack[3], d);
}

TEST(Pack, ArithmeticIsThatOfItsLanes) {
  const Pack x(1, -2, 3, 0.5), y(4, 5, -8, 2);
  expect_lanes(x + y, 5, 3, -5, 2.5);
  expect_lanes(x - y, -3, -7, 11, -1.5);
  expect_lanes(x * y, 4, -10, -24, 1);
  expect_lanes(x / y, 0.25, -0.4, -0.375, 0.25);
  expect_lanes(-x, -1, 2, -3, -0.5);
  expect_lanes(x * 2, 2, -4, 6, 1);
  expect_lanes(sqrt(Pack(4, 9, 16, 0)), 2, 3, 4, 0);
  Pack z = x;
  z += y;
  z *= y;
  z -= x;
  z /= Pack(2);
  expect_lanes(z, 9.5, 8.5, 18.5, 2.25);
  z.set(2, 7);
  expect_lanes(z, 9.5, 8.5, 7, 2.25);
}

/// Sines and cosines are those that doubles get, by whatever way they are asked for.
TEST(Pack, SinesAndCosinesAreThoseOfItsLanes) {
  const Pack angle(0.1, -2.5, 1e10, 3e9);
  const auto expected = qvgen::sines_and_cosines<double>(angle[0], angle[1], angle[2], angle[3]);
  const auto found = qvgen::sines_and_cosines<Pack>(angle, angle + Pack(1));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(found.sine[0][i], expected.sine[i]);
    EXPECT_EQ(found.cosine[0][i], expected.cosine[i]);
    EXPECT_EQ(sin(angle)[i], expected.sine[i]);
    EXPECT_EQ(cos(angle)[i], expected.cosine[i]);
    EXPECT_EQ(found.sine[1][i], qvgen::sines_and_cosines<double>(angle[i] + 1).sine[0]);
  }
}

TEST(Pack, StandsInEigenMatrices) {
  Eigen::Matrix<Pack, 2, 2> m;
  m << Pack(1, 2, 3, 4), Pack(0), Pack(1), Pack(2);
  const Eigen::Matrix<Pack, 2, 1> v(Pack(1), Pack(0, 1, 2, 3));
  const Eigen::Matrix<Pack, 2, 1> product = m * v;
  expect_lanes(product[0], 1, 2, 3, 4);
  expect_lanes(product[1], 1, 3, 5, 7);
}

}  // namespace
