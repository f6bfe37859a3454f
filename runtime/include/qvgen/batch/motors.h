// SPDX-License-Identifier: MIT
// Batches of arms with motors: solved in joints, given in motors (qvgen/inverse/motors.h).
#pragma once

#include <cstddef>

#include <qvgen/batch/solutions.h>
#include <qvgen/inverse/motors.h>

namespace qvgen::batch {

/// Writes solutions in motors in place of those in joints.
template <class Map>
void in_motors(std::size_t count, const BatchOfSolutions& found) {
  constexpr int dof = Map::dof;
  for (std::size_t k = 0; k < count; ++k)
    for (int s = 0; s < found.count(0, k); ++s) {
      const auto first = static_cast<std::size_t>(s * dof);
      Joints<dof> joints;
      for (int i = 0; i < dof; ++i) joints[i] = found.q(first + static_cast<std::size_t>(i), k);
      const Joints<dof> motors = Map::motors(joints);
      for (int i = 0; i < dof; ++i) found.q(first + static_cast<std::size_t>(i), k) = motors[i];
    }
}

}  // namespace qvgen::batch
