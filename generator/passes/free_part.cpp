// SPDX-License-Identifier: MIT
#include "passes/free_part.h"

#include <algorithm>
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
        is_free_(is_free),
        free_(function.graph.size(), false),
        moved_(function.graph.size()),
        set_up_(function.graph.size()) {
    const dag::Function copy = dag::rebuild(meanings);
    result_.constants.graph = copy.graph;
    for (const dag::Output& output : copy.outputs) meaning_.emplace(output.name, output.value);
  }

  FreePart run() {
    for (const std::uint32_t id : dag::reachable(function_)) {
      free_[id] = is_free(function_.graph.node(id));
      if (!free_[id]) moved_[id] = move(function_.graph.node(id));
    }
    for (const dag::Output& output : function_.outputs)
      result_.function.outputs.push_back({output.name, moved(output.value)});
    return std::move(result_);
  }

 private:
  bool is_free(const Node& node) const {
    if (node.op == Op::constant) return true;
    if (node.op == Op::symbol) return is_free_(function_.graph.symbol_of(node));
    const auto term_is_free = [&](const auto& term) { return is_free_(term.first); };
    if (node.op == Op::sine || node.op == Op::cosine) {
      const dag::Angle& angle = function_.graph.angle_of(node);
      return std::all_of(angle.terms.begin(), angle.terms.end(), term_is_free);
    }
    return std::all_of(node.operands.begin(), node.operands.end(), [&](Edge e) { return free_[e.node]; });
  }

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
    const std::string name = free_part_name(place->second);
    if (inserted) result_.constants.outputs.push_back({name, {value.node, false}});
    const Edge symbol = result_.function.graph.symbol(name);
    return value.negative ? -symbol : symbol;
  }

  const dag::Function& function_;
  const dag::IsFree& is_free_;
  std::vector<bool> free_;
  std::vector<std::optional<Edge>> moved_, set_up_;
  std::map<std::string, Edge> meaning_;
  std::map<std::uint32_t, std::size_t> slots_;
  FreePart result_;
};

}  // namespace

FreePart split_free_part(const dag::Function& function, const dag::Function& meanings,
                         const dag::IsFree& is_free) {
  return Splitter(function, meanings, is_free).run();
}

std::string free_part_name(std::size_t index) { return "$" + std::to_string(index); }

}  // namespace qvgen::passes
