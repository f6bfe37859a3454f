// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "compare/recorder.h"

/// The types of a library of rigid motions, each operation as such libraries have it: every entry is a
/// general number. Multiplications and additions in brackets.
namespace qvgen::compare {

using Vector = std::array<Value, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows

Vector operator+(const Vector& a, const Vector& b);  ///< (0, 3)
Vector operator-(const Vector& a, const Vector& b);  ///< (0, 3)
Vector operator-(const Vector& a);                   ///< (0, 0)
Vector operator*(const Value& s, const Vector& v);   ///< (3, 0)
Value dot(const Vector& a, const Vector& b);         ///< (3, 2)
Vector cross(const Vector& a, const Vector& b);      ///< (6, 3)
Matrix operator*(const Matrix& a, const Matrix& b);  ///< (27, 18)
Vector operator*(const Matrix& m, const Vector& v);  ///< (9, 6)
Matrix transpose(const Matrix& m);                   ///< (0, 0)
Vector column(const Matrix& m, std::size_t k);       ///< (0, 0)
/// Rodrigues' formula: (1 - c) a a^T + c 1 + s [a] for a unit vector a, (12, 10).
Matrix rotation(const Vector& axis, const Recorder::Circle& angle, Recorder& recorder);

/// Quaternion [w, v], Hamilton product.
struct Quaternion {
  Value w;
  Vector v;
};
Quaternion operator*(const Quaternion& a, const Quaternion& b);  ///< (16, 12)
Quaternion operator+(const Quaternion& a, const Quaternion& b);  ///< (0, 4)
Quaternion operator*(const Value& s, const Quaternion& q);       ///< (4, 0)
Quaternion conjugate(const Quaternion& q);                       ///< (0, 0)
/// q x q^-1 = x + 2 w (v x x) + 2 v x (v x x) (thesis, below 1.12), doubled once: (15, 15).
Vector turned(const Quaternion& q, const Vector& x);
/// [cos, sin axis] of half the angle (thesis 1.1): (3, 0).
Quaternion rotation(const Vector& axis, const Recorder::Circle& half_angle);

/// Quaternion/vector pair, x -> q x q^-1 + p (thesis 1.9, 1.10).
struct Pair {
  Quaternion q;
  Vector p;
};
Pair operator*(const Pair& a, const Pair& b);  ///< (31, 30), thesis 1.12

/// The upper three rows of a homogeneous matrix.
struct Transform {
  Matrix r;
  Vector p;
};
Transform operator*(const Transform& a, const Transform& b);  ///< (36, 27)

/// q + e p q / 2 with e^2 = 0.
struct DualQuaternion {
  Quaternion real, dual;
};
DualQuaternion operator*(const DualQuaternion& a, const DualQuaternion& b);  ///< (48, 40)

}  // namespace qvgen::compare
