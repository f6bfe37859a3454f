// SPDX-License-Identifier: MIT
// Divisors that several quotients share: one reciprocal, and products with it. It costs a division where
// there were many, and half a unit in the last place.
#include <map>

#include "dag/rebuild.h"
#include "passes/pass.h"

namespace qvgen::passes {

dag::Function share_reciprocals(const dag::Function& function) {
  std::map<std::uint32_t, int> quotients;  // by divisor
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    if (node.op == dag::Op::quotient) ++quotients[node.operands[1].node];
  }
  return dag::rebuild(function, [&](const auto& from, const auto& node, const auto& operands, auto& to) {
    if (node.op != dag::Op::quotient || quotients.at(node.operands[1].node) < 2)
      return dag::copy_node_as_is(from, node, operands, to);
    return to.product({operands[0], to.quotient(to.constant(1), operands[1])});
  });
}

}  // namespace qvgen::passes
