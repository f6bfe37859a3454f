// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "passes/cost.h"
#include "passes/search/classes.h"
#include "passes/search/load.h"

namespace qvgen::passes::search_detail {

/// One way to compute a node of the network: its price, what it needs, and the angle it uses, if any.
struct Choice {
  std::int32_t cost = 0;
  std::int32_t angle = -1;
  std::uint32_t operand_count = 0;
  std::array<std::uint32_t, 2> operands{};
  std::int32_t node = -1;  ///< index in the class, -1 for the leaf itself
};

/// Network for extraction: classes as numbers, prices as integers (so that no rounding enters a decision),
/// free classes gone.
struct Network {
  static constexpr std::int32_t unit = 1024;  ///< price of cost 1

  std::vector<std::uint32_t>
      first;  ///< choices of class i are [first[i], first[i + 1]); none for free classes
  std::vector<Choice> choices;
  std::vector<std::int32_t> angle_costs;
  std::vector<std::uint32_t> outputs;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(first.size() - 1); }
  [[nodiscard]] std::uint32_t choice_count(std::uint32_t node) const { return first[node + 1] - first[node]; }
};

Network make_network(const Classes& classes, const AngleTable& angles, const std::vector<Ref>& outputs,
                     const CostModel& cost);

}  // namespace qvgen::passes::search_detail
