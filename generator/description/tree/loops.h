// SPDX-License-Identifier: MIT
// Loops of a tree of links: closures between nodes of a file become closures between links of the mechanism,
// in whose frames all that is fixed is folded.
#pragma once

#include <vector>

#include "description/tree/tree_reader.h"

namespace qvgen::description::tree {

/// Returns the tips and, behind them, nodes of closures that move against the base: what they hang on belongs
/// to the mechanism.
std::vector<std::size_t> with_closures(const std::vector<Node>& nodes, std::size_t base,
                                       const std::vector<Closure>& closures, std::vector<std::size_t> tips);

/// Adds the closures to a mechanism whose joints were read, with the joints that are driven. Links and joints
/// that it has not are reported at their places.
void close_loops(Context& context, const std::vector<Node>& nodes, TreeReader& reader, const Loops& loops,
                 const std::vector<Closure>& closures, model::Mechanism& mechanism);

}  // namespace qvgen::description::tree
