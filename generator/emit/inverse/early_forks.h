// SPDX-License-Identifier: MIT
// Forks of closed loops that do not read what the forks around them leave. The arms of a delta are three such
// forks: each is solved once for each of its own signs, six times in all and not fourteen, and the product of
// signs combines what is stored. Assemblies and their numbers stay those of the nested loops.
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/plan.h"

namespace qvgen::emit {

/// A fork that is solved outside of loops of other forks, with steps of one value that follow from it.
struct EarlyFork {
  std::size_t step = 0;             ///< the fork
  std::vector<std::size_t> behind;  ///< those that follow from it and from what is known at its depth
  int number = 0;                   ///< of the fork, and so of the loop over its signs, from 0
  int depth = 0;                    ///< how many loops are around the place at which it is solved
  std::vector<std::string> handed;  ///< names of its values that steps elsewhere read

  [[nodiscard]] bool has(std::size_t index) const;
};

/// Returns the early forks of a plan, in its order.
std::vector<EarlyFork> early_forks(const derive::inverse::Plan& plan);

}  // namespace qvgen::emit
