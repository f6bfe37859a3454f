// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/arithmetic.h"
#include "model/inverse.h"

namespace qvgen::model {
namespace {

Vector3 scale(const Expression& factor, const Vector3& v) {
  return {multiply(factor, v[0]), multiply(factor, v[1]), multiply(factor, v[2])};
}

Expression dot(const Vector3& a, const Vector3& b) {
  return add(add(multiply(a[0], b[0]), multiply(a[1], b[1])), multiply(a[2], b[2]));
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  const auto entry = [&](std::size_t i, std::size_t j) {
    return subtract(multiply(a[i], b[j]), multiply(a[j], b[i]));
  };
  return {entry(1, 2), entry(2, 0), entry(0, 1)};
}

}  // namespace

Vector3 add(const Vector3& a, const Vector3& b) {
  return {add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2])};
}

Vector3 subtract(const Vector3& a, const Vector3& b) {
  return {subtract(a[0], b[0]), subtract(a[1], b[1]), subtract(a[2], b[2])};
}

bool is_literal_zero(const Vector3& v) {
  return std::all_of(v.begin(), v.end(), [](const Expression& e) { return e.is_literal_zero(); });
}

Vector3 unit_vector(std::size_t index, long sign) {
  Vector3 result;
  result.at(index) = Expression(cln::cl_RA(sign));
  return result;
}

Vector3 rotate(const Turn& turn, const Vector3& v) {
  const Expression c = cosine(turn.angle);
  const Expression s = sine(turn.angle);
  const Expression along = dot(turn.axis, v);
  const Vector3 across = subtract(v, scale(along, turn.axis));
  return add(add(scale(along, turn.axis), scale(c, across)), scale(s, cross(turn.axis, v)));
}

Vector3 rotate(const std::vector<Turn>& turns, const Vector3& v) {
  Vector3 result = v;
  for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn) result = rotate(*turn, result);
  return result;
}

Displacement compose(const Displacement& first, const Displacement& second) {
  Displacement result = first;
  result.turns.insert(result.turns.end(), second.turns.begin(), second.turns.end());
  if (!is_literal_zero(second.translation)) {
    result.translation = add(first.translation, rotate(first.turns, second.translation));
  }
  return result;
}

Displacement inverse(const Displacement& displacement) {
  Displacement result;
  for (auto turn = displacement.turns.rbegin(); turn != displacement.turns.rend(); ++turn)
    result.turns.push_back({turn->axis, negate(turn->angle)});
  result.translation = rotate(result.turns, subtract({}, displacement.translation));
  return result;
}

}  // namespace qvgen::model
