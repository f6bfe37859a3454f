// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <ginac/ginac.h>

namespace qvgen::symbolic {

struct Vector {
  GiNaC::ex x = 0, y = 0, z = 0;
};
Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator-(const Vector& a);
Vector operator*(const GiNaC::ex& s, const Vector& v);
GiNaC::ex dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

/// Quaternion [w, <x, y, z>], scalar first, Hamilton product (thesis 1.1, 1.2).
struct Quaternion {
  GiNaC::ex w = 1, x = 0, y = 0, z = 0;
};
Quaternion operator*(const Quaternion& a,
                     const Quaternion& b);            ///< (1.11), with the sign of v1 x v2 corrected
Quaternion inverse(const Quaternion& q);              ///< of a unit quaternion (1.13)
Vector rotate(const Quaternion& q, const Vector& v);  ///< q v q^-1, as in (1.12)
/// [cos(angle/2), sin(angle/2) axis], axis a unit vector (1.1).
Quaternion rotation(const Vector& axis, const GiNaC::ex& angle);

using Matrix3 = std::array<std::array<GiNaC::ex, 3>, 3>;
Matrix3 to_matrix(const Quaternion& q);  ///< (1.3)
Vector operator*(const Matrix3& m, const Vector& v);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
Matrix3 transpose(const Matrix3& m);

/// Quaternion/vector pair (q, p): x -> q x q^-1 + p (thesis 1.9, 1.10).
struct Pair {
  Quaternion q;
  Vector p;
};
Pair operator*(const Pair& a, const Pair& b);  ///< (1.12)
Pair inverse(const Pair& a);                   ///< (1.14)
Vector operator*(const Pair& a, const Vector& x);

}  // namespace qvgen::symbolic
