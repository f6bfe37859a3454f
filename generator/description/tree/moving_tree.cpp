// SPDX-License-Identifier: MIT
#include "description/tree/moving_tree.h"

#include <algorithm>

namespace qvgen::description::tree {

MovingTree moving_tree(const std::vector<Node>& nodes, std::size_t base) {
  const std::size_t count = nodes.size();
  MovingTree tree{std::vector<std::size_t>(count, 0), std::vector<std::size_t>(count, 0),
                  std::vector<std::size_t>(count, Node::none), std::vector<std::vector<std::size_t>>(count)};
  std::vector<std::size_t> carrier(count, Node::none);  // the last moving link, up to a node
  std::vector<std::size_t> order{base};                 // parents before children
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t parent = order[i];
    for (const std::size_t child : nodes[parent].children) {
      order.push_back(child);
      tree.joints[child] = tree.joints[parent] + (nodes[child].moves ? 1 : 0);
      tree.before[child] = carrier[parent];
      carrier[child] = nodes[child].moves ? child : carrier[parent];
      if (nodes[child].moves && carrier[parent] != Node::none) tree.next[carrier[parent]].push_back(child);
    }
  }
  for (std::size_t i = order.size(); i-- > 1;) {
    const std::size_t child = order[i], parent = nodes[child].parent;
    tree.height[parent] = std::max(tree.height[parent], tree.height[child] + (nodes[child].moves ? 1 : 0));
  }
  return tree;
}

}  // namespace qvgen::description::tree
