// SPDX-License-Identifier: MIT
#include "canonical/placement.h"

#include <cln/float.h>
#include <cln/integer.h>

#include "canonical/arm.h"
#include "canonical/pi.h"
#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::canonical {
namespace {

using cln::cl_R;

cln::float_format_t format() { return cln::float_format(model::evaluation_digits); }

/// Zeros and ones that rounding hides are put right.
cl_R cleaned(const cl_R& value) {
  for (const int whole : {0, 1, -1})
    if (model::vanishes(value - whole)) return whole;
  return value;
}

Rotation cleaned(Rotation r) {
  for (auto& row : r)
    for (cl_R& entry : row) entry = cleaned(entry);
  return r;
}

cl_R sine(const cl_R& angle) { return cleaned(cln::sin(cln::cl_float(angle, format()))); }
cl_R cosine(const cl_R& angle) { return cleaned(cln::cos(cln::cl_float(angle, format()))); }

cl_R atan2(const cl_R& y, const cl_R& x) {
  if (cln::zerop(y) && cln::zerop(x)) return 0;
  return cln::atan(cln::cl_float(x, format()), cln::cl_float(y, format()));
}

cl_R dot(const std::array<cl_R, 3>& a, const std::array<cl_R, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Rodrigues' formula.
Rotation about(const std::array<cl_R, 3>& axis, const cl_R& angle) {
  const cl_R c = cosine(angle);
  const cl_R s = sine(angle);
  Rotation r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = (1 - c) * axis[i] * axis[j] + (i == j ? c : cl_R(0));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    r[k][j] = r[k][j] + s * axis[i];
    r[j][k] = r[j][k] - s * axis[i];
  }
  return cleaned(r);
}

std::array<cl_R, 3> values(const model::Vector3& v) {
  return {cleaned(model::evaluate(v[0])), cleaned(model::evaluate(v[1])), cleaned(model::evaluate(v[2]))};
}

}  // namespace

Rotation identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
Rotation about_x(const cl_R& angle) { return about({1, 0, 0}, angle); }
Rotation about_z(const cl_R& angle) { return about({0, 0, 1}, angle); }

Rotation operator*(const Rotation& a, const Rotation& b) {
  const Rotation columns = transpose(b);
  Rotation product;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) product[i][j] = dot(a[i], columns[j]);
  return cleaned(product);
}

Rotation transpose(const Rotation& r) {
  Rotation result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = r[j][i];
  return result;
}

LengthVector operator*(const Rotation& r, const LengthVector& v) {
  LengthVector result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] = result[i] + r[i][j] * v[j];
  return result;
}

Placement operator*(const Placement& a, const Placement& b) {
  Placement result{a.rotation * b.rotation, a.rotation * b.translation};
  for (std::size_t i = 0; i < 3; ++i) result.translation[i] = a.translation[i] + result.translation[i];
  return result;
}

bool is_right_angled(const Rotation& r) {
  for (const auto& row : r)
    for (const cl_R& entry : row)
      if (!cln::zerop(entry) && cln::abs(entry) != 1) return false;
  return true;
}

Rotation from_z_to(const model::Vector3& axis) {
  const auto [x, y, z] = values(axis);
  if (cln::zerop(x) && cln::zerop(y)) return cln::minusp(z) ? about_x(pi()) : identity();
  // Rz(phi) Rx(theta) z = (sin theta sin phi, -sin theta cos phi, cos theta)
  const cl_R across = cln::sqrt(cln::cl_float(x * x + y * y, format()));
  return about_z(wrapped(atan2(x, -y))) * about_x(wrapped(atan2(across, z)));
}

Placement to_placement(const model::Displacement& displacement, Definitions& definitions) {
  Placement result{identity(), {}};
  for (std::size_t i = 0; i < 3; ++i)
    result.translation[i] = to_length(displacement.translation[i], definitions);
  for (const model::Turn& turn : displacement.turns)
    result.rotation =
        result.rotation * about(values(turn.axis), model::evaluate(turn.angle, constants_of(turn.angle)));
  return result;
}

Euler euler(const Rotation& r) {
  Euler result;
  if (cln::zerop(r[0][2]) && cln::zerop(r[1][2])) {
    // Rx(0 or pi) Rz(last), the whole turn about z last.
    result.is_parallel = true;
    const bool flipped = cln::minusp(r[2][2]);
    result.first = 0;
    result.middle = flipped ? pi() : cl_R(0);
    result.last = wrapped(atan2(flipped ? cl_R(-r[1][0]) : r[1][0], r[0][0]));
    return result;
  }
  const cl_R across = cln::sqrt(cln::cl_float(r[0][2] * r[0][2] + r[1][2] * r[1][2], format()));
  result.first = wrapped(atan2(r[0][2], -r[1][2]));
  result.middle = wrapped(atan2(across, r[2][2]));
  result.last = wrapped(atan2(r[2][0], r[2][1]));
  return result;
}

cl_R wrapped(const cl_R& radians) {
  const cl_R turns = cln::cl_float(radians, format()) / pi();
  const cl_R whole = turns - 2 * cln::ceiling1((turns - 1) / 2);
  const cln::cl_I quarters = cln::round1(2 * whole);
  const bool is_quarter = model::vanishes(2 * whole - quarters);
  if (!is_quarter) return whole * pi();
  if (cln::zerop(quarters)) return 0;
  return (quarters == -2 ? cl_R(1) : cl_R(cln::cl_RA(quarters) / 2)) * pi();
}

model::Expression to_angle(const cl_R& radians) {
  const cl_R angle = wrapped(radians);
  const cl_R quarters = 2 * angle / pi();
  const cln::cl_I whole = cln::round1(quarters);
  if (model::vanishes(quarters - whole))
    return model::multiply(model::Expression(cln::cl_RA(whole) / 2), model::Expression::pi());
  return model::Expression::symbol(exact::name_of_angle(angle));
}

std::vector<model::Turn> to_turns(const Euler& angles) {
  std::vector<model::Turn> turns;
  const auto add = [&](std::size_t axis, const cl_R& angle) {
    if (!cln::zerop(wrapped(angle))) turns.push_back({model::unit_vector(axis), to_angle(angle)});
  };
  add(2, angles.first);
  add(0, angles.middle);
  add(2, angles.last);
  return turns;
}

}  // namespace qvgen::canonical
