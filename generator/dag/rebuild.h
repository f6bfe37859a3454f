// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "dag/graph.h"

namespace qvgen::dag {

/// Builds a node in another graph from operands that are there already.
Edge copy_node(const Graph& from, const Node& node, const std::vector<Edge>& operands, Graph& to);

/// Builds a node from just these operands (Graph::as_is), for rewrites that only give leaves other names and
/// must not undo what a search has chosen.
Edge copy_node_as_is(const Graph& from, const Node& node, const std::vector<Edge>& operands, Graph& to);

/// Makes a node of the new graph out of an old node and its already rebuilt operands.
using Rewrite =
    std::function<Edge(const Graph& from, const Node& node, const std::vector<Edge>& operands, Graph& to)>;

/// Rebuilds bottom-up what the outputs reach, in an order that depends on structure alone: dead code goes,
/// the builders normalise again, and node numbers no longer remember how the old graph came about.
Function rebuild(const Function& function, const Rewrite& rewrite = copy_node);

/// Nodes that the outputs reach, operands before users.
std::vector<std::uint32_t> reachable(const Function& function);

}  // namespace qvgen::dag
