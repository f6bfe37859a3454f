// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "description/tree/tree.h"

namespace qvgen::description::tree {

/// The moving links behind a base alone: those between which nothing moves are one. By node; zero and none
/// for nodes that do not hang on the base.
struct MovingTree {
  std::vector<std::size_t> joints;             ///< that move between the base and a node
  std::vector<std::size_t> height;             ///< most joints that move one after the other behind a node
  std::vector<std::size_t> before;             ///< the moving link before a moving link, none: the base
  std::vector<std::vector<std::size_t>> next;  ///< the moving links behind a moving link
};

MovingTree moving_tree(const std::vector<Node>& nodes, std::size_t base);

}  // namespace qvgen::description::tree
