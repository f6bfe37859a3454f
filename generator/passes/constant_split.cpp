// SPDX-License-Identifier: MIT
#include "passes/constant_split.h"

#include <map>
#include <optional>
#include <vector>

#include "dag/rebuild.h"

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Node;
using dag::Op;

class Splitter {
 public:
  Splitter(const dag::Function& function, const dag::Function& meanings, const dag::IsFree& is_free)
      : function_(function),
        free_(dag::free_nodes(function, is_free)),
        moved_(function.graph.size()),
        set_up_(function.graph.size()) {
    const dag::Function copy = dag::rebuild(meanings);
    result_.constants.graph = copy.graph;
    for (const dag::Output& output : copy.outputs) meaning_.emplace(output.name, output.value);
  }

  ConstantSplit run() {
    for (const std::uint32_t id : dag::reachable(function_))
      if (!free_[id]) moved_[id] = move(function_.graph.node(id));
    for (const dag::Output& output : function_.outputs)
      result_.function.outputs.push_back({output.name, moved(output.value)});
    return std::move(result_);
  }

 private:
  Edge move(const Node& node) {
    std::vector<Edge> operands;
    for (const Edge operand : node.operands) operands.push_back(moved(operand));
    if (node.op == Op::sum || node.op == Op::product) return result_.function.graph.as_is(node.op, operands);
    return dag::copy_node(function_.graph, node, operands, result_.function.graph);
  }

  Edge moved(Edge edge) {
    if (!free_[edge.node]) return edge.negative ? -*moved_[edge.node] : *moved_[edge.node];
    if (function_.graph.is_constant(edge))
      return result_.function.graph.constant(function_.graph.value_of(edge));
    const Edge symbol = slot(set_up(edge.node));
    return edge.negative ? -symbol : symbol;
  }

  /// The free node in the set-up graph, meanings put in.
  Edge set_up(std::uint32_t id) {
    if (set_up_[id]) return *set_up_[id];
    const Node& node = function_.graph.node(id);
    std::vector<Edge> operands;
    for (const Edge operand : node.operands)
      operands.push_back(operand.negative ? -set_up(operand.node) : set_up(operand.node));
    Edge result;
    if (node.op == Op::symbol && meaning_.contains(function_.graph.symbol_of(node)))
      result = meaning_.at(function_.graph.symbol_of(node));
    else
      result = dag::copy_node(function_.graph, node, operands, result_.constants.graph);
    set_up_[id] = result;
    return result;
  }

  Edge slot(Edge value) {
    const auto [place, inserted] = slots_.try_emplace(value.node, slots_.size());
    const std::string name = "$" + std::to_string(place->second);
    if (inserted) result_.constants.outputs.push_back({name, {value.node, false}});
    const Edge symbol = result_.function.graph.symbol(name);
    return value.negative ? -symbol : symbol;
  }

  const dag::Function& function_;
  std::vector<bool> free_;
  std::vector<std::optional<Edge>> moved_, set_up_;
  std::map<std::string, Edge> meaning_;
  std::map<std::uint32_t, std::size_t> slots_;
  ConstantSplit result_;
};

}  // namespace

ConstantSplit split_constants(const dag::Function& function, const dag::Function& meanings,
                              const dag::IsFree& is_free) {
  return Splitter(function, meanings, is_free).run();
}

}  // namespace qvgen::passes
