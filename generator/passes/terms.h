// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dag/graph.h"

namespace qvgen::passes {

/// One term of a sum as a product: coefficient * factors, factors as node numbers in ascending order.
struct Term {
  exact::Number coefficient;
  std::vector<std::uint32_t> factors;
};

std::vector<Term> terms_of_sum(const dag::Graph& graph, const std::vector<dag::Edge>& operands);
dag::Edge to_edge(dag::Graph& graph, const Term& term);
dag::Edge to_edge(dag::Graph& graph, const std::vector<Term>& terms);

/// How often each node is used by others or as an output.
std::vector<int> use_counts(const dag::Function& function);

}  // namespace qvgen::passes
