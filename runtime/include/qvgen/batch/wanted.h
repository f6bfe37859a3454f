// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <qvgen/batch/view.h>

namespace qvgen::batch {

/// Wanted solutions of each pose: within limits, the nearest to the pose's seed first; all by branch if there
/// are no seeds. Numbers alone, for code that is compiled for other machines than the rest.
struct WantedSolutions {
  Batch<const double> seeds;      ///< a row for each joint
  const double* lower = nullptr;  ///< limits, the same for all poses
  const double* upper = nullptr;
  const bool* revolute = nullptr;

  [[nodiscard, gnu::always_inline]] WantedSolutions part(std::size_t first, std::size_t most) const {
    return {seeds.part(first, most), lower, upper, revolute};
  }
};

}  // namespace qvgen::batch
