// SPDX-License-Identifier: MIT
#include "compare/library.h"

#include "compare/chain.h"

namespace qvgen::compare {

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return a + -b; }
Vector operator-(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
Vector operator*(const Value& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
Value dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Matrix transpose(const Matrix& m) { return {column(m, 0), column(m, 1), column(m, 2)}; }
Vector column(const Matrix& m, std::size_t k) { return {m[0][k], m[1][k], m[2][k]}; }
Vector operator*(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
Matrix operator*(const Matrix& a, const Matrix& b) {
  return transpose({a * column(b, 0), a * column(b, 1), a * column(b, 2)});
}

Matrix rotation(const Vector& a, const Recorder::Circle& angle, Recorder& recorder) {
  const Value& c = angle.cosine;
  const Vector versed = (recorder.literal(1) - c) * a;
  const Vector s = angle.sine * a;
  const Value xy = versed[0] * a[1], yz = versed[1] * a[2], zx = versed[2] * a[0];
  return {{{versed[0] * a[0] + c, xy - s[2], zx + s[1]},
           {xy + s[2], versed[1] * a[1] + c, yz - s[0]},
           {zx - s[1], yz + s[0], versed[2] * a[2] + c}}};
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Quaternion operator+(const Quaternion& a, const Quaternion& b) { return {a.w + b.w, a.v + b.v}; }
Quaternion operator*(const Value& s, const Quaternion& q) { return {s * q.w, s * q.v}; }
Quaternion conjugate(const Quaternion& q) { return {q.w, -q.v}; }

Vector turned(const Quaternion& q, const Vector& x) {
  const Vector across = cross(q.v, x);
  const Vector twice = across + across;
  return x + q.w * twice + cross(q.v, twice);
}

Quaternion rotation(const Vector& axis, const Recorder::Circle& half_angle) {
  return {half_angle.cosine, half_angle.sine * axis};
}

Pair operator*(const Pair& a, const Pair& b) { return {a.q * b.q, turned(a.q, b.p) + a.p}; }

Transform operator*(const Transform& a, const Transform& b) { return {a.r * b.r, a.r * b.p + a.p}; }

DualQuaternion operator*(const DualQuaternion& a, const DualQuaternion& b) {
  return {a.real * b.real, a.real * b.dual + a.dual * b.real};
}

Quaternion identity_quaternion(Recorder& recorder) {
  return {recorder.entry(1), {recorder.entry(0), recorder.entry(0), recorder.entry(0)}};
}

Vector zero(Recorder& recorder) { return {recorder.entry(0), recorder.entry(0), recorder.entry(0)}; }

Matrix identity(Recorder& recorder) {
  const auto row = [&](long x, long y, long z) {
    return Vector{recorder.entry(x), recorder.entry(y), recorder.entry(z)};
  };
  return {row(1, 0, 0), row(0, 1, 0), row(0, 0, 1)};
}

}  // namespace qvgen::compare
