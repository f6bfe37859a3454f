// SPDX-License-Identifier: MIT
#include "derive/jacobian/wrist.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

Vector expanded(const Vector& v) { return {v.x.expand(), v.y.expand(), v.z.expand()}; }
bool vanishes(const Vector& v) {
  const Vector e = expanded(v);
  return e.x.is_zero() && e.y.is_zero() && e.z.is_zero();
}

/// How far along `moving` the point lies in which the line origin + t * moving meets the line along `fixed`
/// through zero.
std::optional<ex> meeting(const Vector& fixed, const Vector& origin, const Vector& moving) {
  const Vector normal = expanded(cross(moving, fixed));
  if (vanishes(normal)) return std::nullopt;
  const ex t = (-dot(cross(origin, fixed), normal) / dot(normal, normal)).expand();
  if (!vanishes(cross(origin + t * moving, fixed))) return std::nullopt;
  return t;
}

}  // namespace

std::optional<Linkage> at_wrist_centre(const Linkage& linkage) {
  const std::size_t n = linkage.pivots.size();
  if (n < 3 || !linkage.beyond.slides.empty()) return std::nullopt;
  const auto* last = &linkage.pivots[n - 3];
  for (int i = 0; i < 3; ++i)
    if (last[i].joint < 0 || (i > 0 && !last[i].before.slides.empty())) return std::nullopt;
  const auto t = meeting(last[0].axis, last[1].before.offset, last[1].axis);
  if (!t) return std::nullopt;
  const Vector from_last = expanded(*t * last[1].axis - last[2].before.offset);
  if (!vanishes(cross(from_last, last[2].axis))) return std::nullopt;
  Linkage result = linkage;
  result.beyond.offset = from_last;
  return result;
}

std::optional<Vector> wrist_centre(const model::Robot& robot) {
  const Linkage arm = linkage(robot);
  const auto centred = arm.variables.size() == 6 ? at_wrist_centre(arm) : std::nullopt;
  if (!centred) return std::nullopt;
  return expanded(rotate(inverse(arm.home), centred->beyond.offset - arm.beyond.offset));
}

Linkage at_last_pivot(const Linkage& linkage) {
  Linkage result = linkage;
  result.beyond.offset = {0, 0, 0};
  return result;
}

}  // namespace qvgen::derive
