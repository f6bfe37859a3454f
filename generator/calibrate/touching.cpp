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
  const auto root = (square - c * c).square_root();
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

}  // namespace

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
