// SPDX-License-Identifier: MIT
#include "report/motion.h"

#include <cmath>

namespace qvgen::report {

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(double factor, const Vector& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& v) { return std::sqrt(dot(v, v)); }
Vector unit(const Vector& v) { return (1 / length(v)) * v; }

Vector normal_to(const Vector& axis) {
  const Vector x{1, 0, 0};
  const Vector other = std::abs(axis[0]) < 0.9 ? x : Vector{0, 1, 0};
  return unit(other - dot(other, axis) * axis);
}

Vector operator*(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Vector column(const Motion& m, std::size_t axis) {
  return {m.rotation[0].at(axis), m.rotation[1].at(axis), m.rotation[2].at(axis)};
}

Motion operator*(const Motion& a, const Motion& b) {
  Motion result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result.rotation.at(row).at(axis) = dot(a.rotation.at(row), column(b, axis));
  result.translation = a.rotation * b.translation + a.translation;
  return result;
}

Motion inverse(const Motion& m) {
  const Matrix back{column(m, 0), column(m, 1), column(m, 2)};
  return {back, -1.0 * (back * m.translation)};
}

Motion turn(const Vector& a, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double v = 1 - c;
  return {{{{c + v * a[0] * a[0], v * a[0] * a[1] - s * a[2], v * a[0] * a[2] + s * a[1]},
            {v * a[1] * a[0] + s * a[2], c + v * a[1] * a[1], v * a[1] * a[2] - s * a[0]},
            {v * a[2] * a[0] - s * a[1], v * a[2] * a[1] + s * a[0], c + v * a[2] * a[2]}}},
          {}};
}

Motion shift(const Vector& way) {
  Motion result;
  result.translation = way;
  return result;
}

Motion frame(const Vector& x, const Vector& z, const Vector& origin) {
  const Vector y = cross(z, x);
  return {{{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}, {x[2], y[2], z[2]}}}, origin};
}

}  // namespace qvgen::report
