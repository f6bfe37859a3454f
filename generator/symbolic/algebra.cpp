// SPDX-License-Identifier: MIT
#include "symbolic/algebra.h"

namespace qvgen::symbolic {

using GiNaC::ex;

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
Vector operator*(const ex& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
ex dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion inverse(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }

Vector rotate(const Quaternion& q, const Vector& v) {
  const Vector axis{q.x, q.y, q.z};
  const Vector turned = cross(axis, v);
  return v + (2 * q.w) * turned + ex(2) * cross(axis, turned);
}

Quaternion rotation(const Vector& axis, const ex& angle) {
  const ex s = GiNaC::sin(angle / 2);
  return {GiNaC::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

Matrix3 to_matrix(const Quaternion& q) {
  const auto& [s, x, y, z] = q;
  return {{{1 - 2 * y * y - 2 * z * z, 2 * x * y - 2 * s * z, 2 * x * z + 2 * s * y},
           {2 * x * y + 2 * s * z, 1 - 2 * x * x - 2 * z * z, 2 * y * z - 2 * s * x},
           {2 * x * z - 2 * s * y, 2 * y * z + 2 * s * x, 1 - 2 * x * x - 2 * y * y}}};
}

Vector operator*(const Matrix3& m, const Vector& v) {
  const auto row = [&](int i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return product;
}

Matrix3 transpose(const Matrix3& m) {
  Matrix3 result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i][j] = m[j][i];
  return result;
}

Pair operator*(const Pair& a, const Pair& b) { return {a.q * b.q, rotate(a.q, b.p) + a.p}; }

Pair inverse(const Pair& a) {
  const Quaternion back = inverse(a.q);
  return {back, -rotate(back, a.p)};
}

Vector operator*(const Pair& a, const Vector& x) { return rotate(a.q, x) + a.p; }

}  // namespace qvgen::symbolic
