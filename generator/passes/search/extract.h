// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dag/graph.h"
#include "passes/search/anneal.h"
#include "passes/search/classes.h"
#include "passes/search/load.h"

namespace qvgen::passes::search_detail {

/// The graph that a selection stands for. Free classes, which the network does not know, take their smallest
/// node.
dag::Function extract(const Classes& classes, const AngleTable& angles, const Network& network,
                      const Selection& selection, const std::vector<std::pair<std::string, Ref>>& outputs);

}  // namespace qvgen::passes::search_detail
