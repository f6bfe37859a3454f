// SPDX-License-Identifier: MIT
#include "emit/ast/straight.h"

#include <algorithm>

#include "dag/rebuild.h"
#include "emit/ast/literal.h"

namespace qvgen::emit::ast {
namespace {

using dag::Edge;
using dag::Op;

class Converter {
 public:
  Converter(const dag::Function& function, const Leaves& leaves, int longest_inline)
      : graph_(function.graph),
        leaves_(leaves),
        longest_inline_(longest_inline),
        uses_(graph_.size(), 0),
        value_(graph_.size()),
        length_(graph_.size(), 0) {
    for (const std::uint32_t id : dag::reachable(function))
      for (const Edge& operand : graph_.node(id).operands) ++uses_[operand.node];
    for (const dag::Output& output : function.outputs) ++uses_[output.value.node];
  }

  Straight convert(const dag::Function& function) {
    for (const std::uint32_t id : dag::reachable(function)) convert(id);
    for (const dag::Output& output : function.outputs)
      result_.outputs.push_back({output.name, with_sign(output.value)});
    return std::move(result_);
  }

 private:
  static bool is_leaf(Op op) {
    return op == Op::constant || op == Op::symbol || op == Op::sine || op == Op::cosine;
  }

  void convert(std::uint32_t id) {
    const dag::Node& node = graph_.node(id);
    value_[id] = expression(node);
    if (is_leaf(node.op)) return;
    length_[id] = 1;
    for (const Edge& operand : node.operands) length_[id] += length_[operand.node];
    if (uses_[id] < 2 && length_[id] <= longest_inline_) return;
    const std::string name = "t" + std::to_string(result_.temporaries.size());
    result_.temporaries.push_back({name, std::move(value_[id])});
    value_[id] = ast::name(name, {"real"});
    length_[id] = 0;
  }

  [[nodiscard]] Expression expression(const dag::Node& node) const {
    switch (node.op) {
      case Op::constant:
        return real(literal(graph_.constant_of(node)));
      case Op::symbol:
        return leaves_.symbol(graph_.symbol_of(node));
      case Op::sine:
        return constant_or(sine_literal(graph_.angle_of(node)), leaves_.sine, node);
      case Op::cosine:
        return constant_or(cosine_literal(graph_.angle_of(node)), leaves_.cosine, node);
      case Op::sum:
        return sum_of(node.operands);
      case Op::product:
        return product_of(node);
      case Op::quotient:
        return quotient(factor(node.operands[0]), factor(node.operands[1]));
      case Op::root:
        return call(Expression::Kind::function, "sqrt", {with_sign(node.operands[0])});
      case Op::arctangent:
        return call(Expression::Kind::named, "atan2",
                    {with_sign(node.operands[0]), with_sign(node.operands[1])});
    }
    return {};
  }

  template <class Leaf>
  [[nodiscard]] Expression constant_or(const std::string& literal, const Leaf& leaf,
                                       const dag::Node& node) const {
    return literal.empty() ? leaf(graph_.angle_of(node)) : real(literal);
  }

  [[nodiscard]] Expression factor(Edge edge) const {
    return edge.negative ? negative(value_[edge.node]) : value_[edge.node];
  }

  /// A value with its sign, which a zero lacks; an inline sum takes the sign term by term.
  [[nodiscard]] Expression with_sign(Edge edge) const {
    if (graph_.is_constant(edge) && graph_.value_of(edge) == 0) edge.negative = false;
    const bool is_inline_sum = graph_.node(edge.node).op == Op::sum && length_[edge.node] > 0;
    if (!edge.negative || !is_inline_sum) return factor(edge);
    std::vector<Edge> terms = graph_.node(edge).operands;
    for (Edge& term : terms) term.negative = !term.negative;
    return sum_of(terms);
  }

  [[nodiscard]] Expression sum_of(std::vector<Edge> terms) const {
    const auto positive = std::find_if(terms.begin(), terms.end(), [](Edge e) { return !e.negative; });
    if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
    Expressions values;
    for (const Edge& term : terms) values.push_back(factor(term));
    return sum(values);
  }

  [[nodiscard]] Expression product_of(const dag::Node& node) const {
    Expressions values;
    for (const Edge& operand : node.operands) values.push_back(factor(operand));
    return product(values);
  }

  const dag::Graph& graph_;
  const Leaves& leaves_;
  int longest_inline_;
  std::vector<int> uses_;
  Expressions value_;
  std::vector<int> length_;
  Straight result_;
};

}  // namespace

Straight straight(const dag::Function& function, const Leaves& leaves, int longest_inline) {
  return Converter(function, leaves, longest_inline).convert(function);
}

bool mentions(const Straight& code, const std::string& name) {
  const auto reads = [&](const Straight::Value& value) { return mentions(value.expression, name); };
  return std::any_of(code.temporaries.begin(), code.temporaries.end(), reads) ||
         std::any_of(code.outputs.begin(), code.outputs.end(), reads);
}

Statements declarations(const std::vector<Straight::Value>& values) {
  Statements statements;
  for (const Straight::Value& value : values)
    statements.push_back(constant({"real"}, value.name, value.expression));
  return statements;
}

}  // namespace qvgen::emit::ast
