// SPDX-License-Identifier: MIT
#include "description/xml/orientation.h"

#include <algorithm>

#include <cln/float.h>
#include <cln/real.h>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

using cln::cl_R;
using tree::Matrix;
using tree::Vector;

cl_R precise(const cl_R& value) { return cln::cl_float(value, cln::float_format(model::evaluation_digits)); }
cl_R angle_of(const cl_R& cosine, const cl_R& sine) {
  if (cln::zerop(sine) && !cln::minusp(cosine)) return 0;
  return cln::atan(precise(cosine), precise(sine));
}
cl_R dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& v) {
  const cl_R length = cln::sqrt(precise(dot(v, v)));
  return {v[0] / length, v[1] / length, v[2] / length};
}
Vector vector(const std::vector<Decimal>& numbers, std::size_t from) {
  return {numbers[from].value, numbers[from + 1].value, numbers[from + 2].value};
}

/// Roll, pitch and yaw; in the two poses where only a combination of roll and yaw is known, yaw is 0.
std::array<cl_R, 3> roll_pitch_yaw(const Matrix& r) {
  const cl_R level = cln::sqrt(precise(cln::square(r[2][1]) + cln::square(r[2][2])));
  const cl_R pitch = angle_of(level, -r[2][0]);
  // Nearer to upright than any number in the file can say: the digits left would be noise.
  if (level < cln::cl_RA(1) / 1'000'000'000) return {angle_of(r[1][1], -r[1][2]), pitch, 0};
  return {angle_of(r[2][2], r[2][1]), pitch, angle_of(r[0][0], r[1][0])};
}

}  // namespace

std::vector<model::Turn> turns_of(const Snap& snap, const Matrix& rotation, const Decimal& written) {
  const auto angles = roll_pitch_yaw(rotation);
  std::array<model::Expression, 3> exact;
  bool all = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto known = snap.part_of_turn(tree::rounded(angles.at(i)), written);
    all = all && known.has_value();
    exact.at(i) = known.value_or(model::Expression());
  }
  std::vector<model::Turn> turns;
  for (std::size_t i = 3; i-- > 0;) {
    const model::Expression angle = all ? exact.at(i) : model::Expression(tree::rounded(angles.at(i)));
    if (!angle.is_literal_zero()) turns.push_back({model::unit_vector(i), angle});
  }
  if (all) snap.note_turns(written, turns, rotation);
  return turns;
}

Matrix matrix_of(const std::vector<Decimal>& q) {
  const cln::cl_RA w = q[0].value, x = q[1].value, y = q[2].value, z = q[3].value;
  const cln::cl_RA n = w * w + x * x + y * y + z * z;
  return {Vector{1 - 2 * (y * y + z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
          Vector{2 * (x * y + w * z) / n, 1 - 2 * (x * x + z * z) / n, 2 * (y * z - w * x) / n},
          Vector{2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, 1 - 2 * (x * x + y * y) / n}};
}

std::optional<Matrix> matrix_of_axes(const std::vector<Decimal>& x_and_y) {
  const Vector first = vector(x_and_y, 0), second = vector(x_and_y, 3);
  const Vector normal = cross(first, second);
  if (cln::zerop(dot(normal, normal))) return std::nullopt;
  const Vector x = unit(first), z = unit(normal), y = cross(z, x);
  return Matrix{Vector{x[0], y[0], z[0]}, Vector{x[1], y[1], z[1]}, Vector{x[2], y[2], z[2]}};
}

Matrix matrix_of_z(const std::vector<Decimal>& direction) {
  const Vector z = unit(vector(direction, 0));
  if (cln::zerop(z[0]) && cln::zerop(z[1])) {  // back to front: about x
    const cl_R sign = cln::minusp(z[2]) ? -1 : 1;
    return {Vector{1, 0, 0}, Vector{0, sign, 0}, Vector{0, 0, sign}};
  }
  const cl_R share = 1 / (1 + z[2]);
  return {Vector{1 - share * z[0] * z[0], -share * z[0] * z[1], z[0]},
          Vector{-share * z[0] * z[1], 1 - share * z[1] * z[1], z[1]}, Vector{-z[0], -z[1], z[2]}};
}

Decimal together(const std::vector<Decimal>& numbers, const std::string& text) {
  // Four numbers, each a little off, turn by up to three times as much.
  Decimal result{0, 1000, 3, numbers.front().place, text};
  for (const Decimal& number : numbers)
    if (cln::denominator(number.value) != 1) result.places = std::min(result.places, number.places);
  return result;
}

}  // namespace qvgen::description::xml
