// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "dag/rebuild.h"
#include "passes/pass.h"

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Graph;
using dag::Op;

/// Two operands of one n-ary node; the second one's sign relative to the first.
struct OperandPair {
  Op op = Op::sum;
  Edge first;
  Edge second;
  friend bool operator==(const OperandPair&, const OperandPair&) = default;
  friend bool operator<(const OperandPair& a, const OperandPair& b) {
    return std::tie(a.op, a.first.node, a.second.node, a.second.negative) <
           std::tie(b.op, b.first.node, b.second.node, b.second.negative);
  }
};

OperandPair make_pair(Op op, Edge a, Edge b) {
  if (b.node < a.node) std::swap(a, b);
  return {op, {a.node, false}, {b.node, a.negative != b.negative}};
}

/// The pair that most n-ary nodes share, if at least two do. Node numbers follow structure (rebuild), and so
/// does the choice among equals.
std::pair<OperandPair, int> most_frequent_pair(const dag::Function& function) {
  std::map<OperandPair, int> frequency;
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    if (node.op != Op::sum && node.op != Op::product) continue;
    std::map<OperandPair, bool> here;
    for (std::size_t i = 0; i < node.operands.size(); ++i)
      for (std::size_t j = i + 1; j < node.operands.size(); ++j)
        here[make_pair(node.op, node.operands[i], node.operands[j])] = true;
    for (const auto& [pair, present] : here) ++frequency[pair];
  }
  std::pair<OperandPair, int> best{{}, 1};
  for (const auto& [pair, count] : frequency)
    if (count > best.second) best = {pair, count};
  return best;
}

/// Positions of the pair in a node's operands, or equal numbers if it is not there.
std::pair<std::size_t, std::size_t> positions(const dag::Node& node, const OperandPair& pair) {
  for (std::size_t i = 0; i < node.operands.size(); ++i)
    for (std::size_t j = i + 1; j < node.operands.size(); ++j)
      if (make_pair(node.op, node.operands[i], node.operands[j]) == pair) return {i, j};
  return {0, 0};
}

dag::Function extract(const dag::Function& function, const OperandPair& pair) {
  const auto rewrite = [&](const Graph& from, const dag::Node& node, const std::vector<Edge>& operands,
                           Graph& to) {
    if (node.op != pair.op || node.operands.size() < 3) return dag::copy_node(from, node, operands, to);
    const auto [i, j] = positions(node, pair);
    if (i == j) return dag::copy_node(from, node, operands, to);
    std::vector<Edge> rest;
    for (std::size_t k = 0; k < operands.size(); ++k)
      if (k != i && k != j) rest.push_back(operands[k]);
    const bool is_sum = node.op == Op::sum;
    rest.push_back(is_sum ? to.sum({operands[i], operands[j]}) : to.product({operands[i], operands[j]}));
    return is_sum ? to.sum(std::move(rest)) : to.product(std::move(rest));
  };
  return dag::rebuild(function, rewrite);
}

}  // namespace

/// Rounds take time by the size of the graph each: larger ones stay as they are.
constexpr std::uint32_t largest_shared = 6'000;

dag::Function share(const dag::Function& function) {
  dag::Function current = dag::rebuild(function);
  if (current.graph.size() > largest_shared) return current;
  // Each extraction removes at least one operation, so the number of rounds is bounded by the operations.
  for (std::uint32_t round = 0; round < function.graph.size(); ++round) {
    const auto [pair, count] = most_frequent_pair(current);
    if (count < 2) break;
    const std::uint32_t before = current.graph.size();
    dag::Function next = extract(current, pair);
    if (next.graph.size() == before) break;
    current = std::move(next);
  }
  return current;
}

}  // namespace qvgen::passes
