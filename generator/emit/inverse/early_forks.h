// SPDX-License-Identifier: MIT
// Forks of closed loops as groups that are solved for both of their signs at once, outside of loops of forks
// that they do not read. The arms of a delta are three such forks: each is solved for its own two signs, and
// the product of signs combines what is stored. The last rod of a palletiser reads both others: it is solved
// for both values of the second one, side by side. Assemblies and their numbers stay those of nested loops.
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
  std::vector<std::string> taken;   ///< names of values of steps elsewhere that it reads
  std::vector<std::string> handed;  ///< names of its values that steps elsewhere read
  int over = -1;  ///< number of the fork whose two values it is solved for at once; -1 for none

  [[nodiscard]] bool has(std::size_t index) const;
};

/// Returns the forks of a plan's signs that can be solved early, in its order. Those that read what the fork
/// just around them leaves are among them only if `all` is true; then they go over that fork's values if they
/// can, wherever these are stored.
std::vector<EarlyFork> early_forks(const derive::inverse::Plan& plan, bool all);

}  // namespace qvgen::emit
