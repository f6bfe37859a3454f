// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "dag/graph.h"

namespace qvgen::passes {

/// A pass: graph in, graph out, same outputs, same values.
struct Pass {
  std::string_view name;
  dag::Function (*run)(const dag::Function&);
};

/// Constants folded, like terms collected, dead code gone.
dag::Function fold(const dag::Function& function);
/// Sums inside sums and products inside products, where nobody else uses the inner one, become one n-ary
/// node.
dag::Function flatten(const dag::Function& function);
/// x sin^2 + x cos^2 -> x and k - k sin^2 -> k cos^2 (and the mirror image) inside sums.
dag::Function trig(const dag::Function& function);
/// a b + a c -> a (b + c), the most frequent factor first.
dag::Function factor(const dag::Function& function);
/// Pairs of operands that several sums (or products) share become a node of their own, most frequent first.
dag::Function share(const dag::Function& function);

/// a/d, b/d -> a r, b r with r = 1/d. Not among all passes, since it rounds once more: for functions with
/// many divisions by few divisors.
dag::Function share_reciprocals(const dag::Function& function);

/// The passes in their order.
const std::vector<Pass>& all_passes();

/// All passes in order, again and again until the operation counts stop falling.
dag::Function simplify(const dag::Function& function);

}  // namespace qvgen::passes
