// SPDX-License-Identifier: MIT
#include "canonical/mass_key.h"

#include <algorithm>
#include <cmath>

#include "exact/named_constant.h"
#include "exact/point.h"
#include "model/evaluate.h"

namespace qvgen::canonical {
namespace {

using cln::cl_R;

cl_R value_of(const model::Expression& expression) {
  const exact::ExactPoint point(1);
  model::Bindings values;
  for (const std::string& name : model::symbols(expression)) {
    const auto constant = exact::named_value(name);
    values[name] = constant ? *constant : point.symbol(name).rational();
  }
  return model::evaluate(expression, values);
}

/// To a billionth, for what is equal may differ by the last of many digits; no more than the type can hold.
std::int64_t rounded(const cl_R& value) {
  constexpr double most = 9e9;
  return std::llround(std::clamp(model::to_double(value), -most, most) * 1e9);
}

std::array<std::int64_t, 3> rotated(const MassKey::Right& r, const std::array<std::int64_t, 3>& v) {
  std::array<std::int64_t, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2];
  return result;
}

}  // namespace

MassKey::MassKey(const model::Inertia& inertia, const Placement& frame) {
  const auto entry = [&](std::size_t k) { return value_of(inertia.inertia[k]); };
  const cl_R xy = entry(3), yz = entry(4), xz = entry(5);
  const Rotation& r = frame.rotation;
  const Rotation own = {{{entry(0), xy, xz}, {xy, entry(1), yz}, {xz, yz, entry(2)}}};
  const Rotation seen = r * own * transpose(r);
  const model::Vector3& centre = inertia.centre_of_mass;
  for (std::size_t i = 0; i < 3; ++i) {
    cl_R sum = value_of(to_expression(frame.translation[i]));
    for (std::size_t k = 0; k < 3; ++k) sum = sum + r[i][k] * value_of(centre[k]);
    centre_[i] = rounded(sum);
    for (std::size_t k = 0; k < 3; ++k) inertia_[i][k] = rounded(seen[i][k]);
  }
}

std::vector<std::int64_t> MassKey::turned(const Right& rotation) const {
  const Vector centre = rotated(rotation, centre_);
  std::array<Vector, 3> rows, columns;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = rotated(rotation, inertia_[i]);
  for (std::size_t k = 0; k < 3; ++k) columns[k] = rotated(rotation, {rows[0][k], rows[1][k], rows[2][k]});
  std::vector<std::int64_t> key(centre.begin(), centre.end());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = i; k < 3; ++k) key.push_back(columns[i][k]);
  return key;
}

}  // namespace qvgen::canonical
