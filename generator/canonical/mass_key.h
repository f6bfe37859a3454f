// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canonical/placement.h"

namespace qvgen::canonical {

/// Centre of mass and inertia of a link in whole numbers, its symbols at random values: tells apart what
/// looks the same but for how the mass lies, whoever describes it.
class MassKey {
 public:
  /// A rotation by right angles, row by row.
  using Right = std::array<std::array<int, 3>, 3>;

  /// Makes the key of a link with that frame, turned by right angles.
  MassKey(const model::Inertia& inertia, const Placement& frame);
  /// As it is seen after a further rotation.
  [[nodiscard]] std::vector<std::int64_t> turned(const Right& rotation) const;

 private:
  using Vector = std::array<std::int64_t, 3>;
  Vector centre_;
  std::array<Vector, 3> inertia_;
};

}  // namespace qvgen::canonical
