// SPDX-License-Identifier: MIT
// The laws of the pair algebra (thesis 1.1-1.14), symbolically, and its conventions against Eigen.
#include "symbolic/algebra.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using namespace qvgen::symbolic;
using GiNaC::ex;
using GiNaC::symbol;

bool equal(const ex& a, const ex& b) { return (a - b).expand().is_zero(); }
bool equal(const Vector& a, const Vector& b) { return equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z); }
bool equal(const Quaternion& a, const Quaternion& b) {
  return equal(a.w, b.w) && equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z);
}
bool equal(const Pair& a, const Pair& b) { return equal(a.q, b.q) && equal(a.p, b.p); }

/// Unit quaternions with rational components, so that the laws of unit quaternions hold exactly.
const Quaternion p{ex(1) / 2, ex(1) / 2, ex(-1) / 2, ex(1) / 2};
const Quaternion q{ex(2) / 7, ex(3) / 7, ex(6) / 7, 0};
const Quaternion r{0, ex(-3) / 5, 0, ex(4) / 5};

struct Symbols {
  symbol x{"x"}, y{"y"}, z{"z"}, u{"u"}, v{"v"}, w{"w"};
  Vector a{x, y, z}, b{u, v, w};
};

TEST(Quaternion, ProductIsHamiltons) {
  const Quaternion i{0, 1, 0, 0};
  const Quaternion j{0, 0, 1, 0};
  const Quaternion k{0, 0, 0, 1};
  EXPECT_TRUE(equal(i * j, k));
  EXPECT_TRUE(equal(j * k, i));
  EXPECT_TRUE(equal(k * i, j));
  EXPECT_TRUE(equal(i * i, Quaternion{-1, 0, 0, 0}));
}

TEST(Quaternion, ProductIsAssociativeAndInverseInverts) {
  EXPECT_TRUE(equal((p * q) * r, p * (q * r)));
  EXPECT_TRUE(equal(q * inverse(q), Quaternion{}));
  EXPECT_TRUE(equal(inverse(p * q), inverse(q) * inverse(p)));
}

TEST(Quaternion, RotatesAsTheSandwichProduct) {
  const Symbols s;
  const Quaternion pure{0, s.x, s.y, s.z};
  const Quaternion sandwich = q * pure * inverse(q);
  EXPECT_TRUE(equal(rotate(q, s.a), Vector{sandwich.x, sandwich.y, sandwich.z}));
  EXPECT_TRUE(equal(rotate(p * q, s.a), rotate(p, rotate(q, s.a))));
  EXPECT_TRUE(equal(dot(rotate(q, s.a), rotate(q, s.b)), dot(s.a, s.b)));
}

TEST(Quaternion, MatrixIsTheSameRotation) {
  const Symbols s;
  EXPECT_TRUE(equal(to_matrix(q) * s.a, rotate(q, s.a)));
  const Matrix3 product = to_matrix(p) * to_matrix(q);
  EXPECT_TRUE(equal(product * s.a, to_matrix(p * q) * s.a));
}

TEST(Quaternion, ConventionIsEigens) {
  const Eigen::Quaterniond eigen = Eigen::Quaterniond(2.0 / 7, 3.0 / 7, 6.0 / 7, 0);
  const Eigen::Vector3d turned = eigen * Eigen::Vector3d(1, 2, 3);
  const Vector ours = rotate(q, {1, 2, 3});
  EXPECT_NEAR(turned.x(), GiNaC::ex_to<GiNaC::numeric>(ours.x).to_double(), 1e-14);
  EXPECT_NEAR(turned.y(), GiNaC::ex_to<GiNaC::numeric>(ours.y).to_double(), 1e-14);
  EXPECT_NEAR(turned.z(), GiNaC::ex_to<GiNaC::numeric>(ours.z).to_double(), 1e-14);
}

TEST(Pair, ProductActsInTurn) {
  const Symbols s;
  const Pair a{p, s.a};
  const Pair b{q, {1, -2, s.u}};
  EXPECT_TRUE(equal((a * b) * s.b, a * (b * s.b)));
  EXPECT_TRUE(equal((a * b) * a, a * (b * a)));
}

TEST(Pair, InverseInverts) {
  const Symbols s;
  const Pair a{q, s.a};
  EXPECT_TRUE(equal(a * inverse(a), Pair{}));
  EXPECT_TRUE(equal(inverse(a) * a, Pair{}));
}

}  // namespace
