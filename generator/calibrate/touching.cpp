// SPDX-License-Identifier: MIT
#include "calibrate/touching.h"

#include <algorithm>

namespace qvgen::calibrate {
namespace {

Field height(Data data, const Surface<Field>& surface, const Vec<Field>& at) {
  if (data == Data::plane) return dot(surface.normal, at) - surface.offset;
  const Vec<Field> from = at - surface.point;
  return dot(from, from) - surface.radius * surface.radius;
}

/// Returns cosine and sine with a cos + b sin + c = 0.
std::optional<CosSin<Field>> solve(Field a, Field b, Field c) {
  const Field square = a * a + b * b;
  if (square.is_zero()) return std::nullopt;
  const auto root = square_root(square - c * c);
  if (!root) return std::nullopt;
  const Field scale = square.inverse();
  return CosSin<Field>{-(a * c + b * *root) * scale, (a * *root - b * c) * scale};
}

/// True if the joint may turn alone: a variable moves it and no other joint.
bool turns_alone(const Geometry<Field>& geometry, std::size_t joint) {
  const auto moves_others = [&](std::size_t variable) {
    for (std::size_t other = 0; other < geometry.joints.size(); ++other)
      for (const VariableShare& share : geometry.joints[other].shares)
        if (other != joint && share.variable == variable) return true;
    return false;
  };
  const JointForm& form = geometry.joints[joint];
  return form.revolute &&
         std::any_of(form.shares.begin(), form.shares.end(),
                     [&](const VariableShare& share) { return !moves_others(share.variable); });
}

/// Returns a root of a value beside the prime field, from its norm and trace.
std::optional<Field> root_from_norm(Field value, Field conjugate) {
  const Field half = Field::from(2).inverse();
  const auto norm = square_root(value * conjugate);
  if (!norm) return std::nullopt;
  for (const Field sign : {*norm, -*norm})
    if (const auto x = square_root(((value + conjugate) * half + sign) * half))
      return *x + (value - conjugate) * half * half * x->inverse();
  return std::nullopt;
}

}  // namespace

std::optional<Field> square_root(Field value) {
  if (value.is_zero()) return value;
  if (const Field conjugate = value.power(Field::prime); !(conjugate == value))
    return root_from_norm(value, conjugate);
  constexpr std::uint64_t minus_one = Field::prime - 1;
  const Field one = Field::from(1);
  if (!(value.power(minus_one / 2) == one)) return std::nullopt;
  std::uint64_t odd = minus_one;
  unsigned twos = 0;
  for (; odd % 2 == 0; odd /= 2) ++twos;
  Field other = Field::from(2);
  while (other.power(minus_one / 2) == one) other = other + one;
  Field step = other.power(odd), root = value.power(odd / 2 + 1), rest = value.power(odd);
  while (!(rest == one)) {
    unsigned order = 0;
    for (Field square = rest; !(square == one); square = square * square) ++order;
    for (unsigned i = order + 1; i < twos; ++i) step = step * step;
    twos = order;
    root = root * step;
    step = step * step;
    rest = rest * step;
  }
  return root;
}

std::optional<Posture<Field>> touching_posture(const Model<Field>& model, Data data,
                                               const Frames<Field>& frames, std::size_t target,
                                               const Surface<Field>& surface, std::uint64_t seed) {
  Posture<Field> posture = random_posture(model.geometry, seed);
  if (data != Data::plane && data != Data::sphere) return posture;
  const Field one = Field::from(1), zero = one - one, half = Field::from(2).inverse();
  for (std::size_t joint = posture.circular.size(); joint-- > 0;) {
    if (!turns_alone(model.geometry, joint)) continue;
    const auto at = [&](Field cosine, Field sine) {
      Posture<Field> other = posture;
      other.circular[joint] = {cosine, sine};
      return height(data, surface, predict(model, other, frames, target).pose.position);
    };
    const Field front = at(one, zero), back = at(-one, zero), side = at(zero, one);
    const Field c = (front + back) * half;
    if (const auto value = solve(front - c, side - c, c)) {
      posture.circular[joint] = *value;
      return posture;
    }
  }
  return std::nullopt;
}

}  // namespace qvgen::calibrate
