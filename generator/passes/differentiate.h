// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"

namespace qvgen::passes {

/// The derivatives of the first `size` nodes of a graph with respect to a symbol, by node, in the same graph:
/// forward, so that derivatives share what the values compute. Roots and arctangents have none:
/// std::domain_error.
std::vector<dag::Edge> derivatives(dag::Graph& graph, std::uint32_t size, const std::string& symbol);

/// A derivative to take: of every output, with respect to the symbol; named `prefix` + number of the output +
/// "_" + number.
struct Direction {
  std::string symbol;
  std::string prefix;
  std::size_t number = 1;
};

/// Appends the derivatives of all outputs in all directions as further outputs.
void append_derivatives(dag::Function& function, const std::vector<Direction>& directions);

}  // namespace qvgen::passes
