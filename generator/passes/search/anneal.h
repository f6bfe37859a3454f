// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "passes/search/network.h"

namespace qvgen::passes::search_detail {

/// Which choice every class takes, as an index among its own; classes without choices have 0.
using Selection = std::vector<std::uint32_t>;

std::int64_t cost_of(const Network& network, const Selection& selection);

/// Steps after which more find nothing better in practice, for the classes in use that have a choice.
std::int64_t sufficient_steps(const Network& network, const Selection& selection);

struct Schedule {
  std::uint64_t seed = 1;
  std::int64_t iterations = 0;
  std::int32_t hot = Network::unit * 3 / 2;  ///< first temperature
  std::int32_t cold = Network::unit / 24;    ///< last temperature
};

/// Simulated annealing over acyclic selections with a fixed number of steps; never returns anything dearer
/// than `start`. The cost is kept up to date by reference counts: a step touches only what it activates or
/// releases.
Selection anneal(const Network& network, const Selection& start, const Schedule& schedule);

}  // namespace qvgen::passes::search_detail
