// SPDX-License-Identifier: MIT
#include "emit/cpp/code.h"

#include <algorithm>

#include "dag/rebuild.h"
#include "emit/cpp/literal.h"

namespace qvgen::emit {
namespace {

using dag::Edge;
using dag::Op;

/// Inner nodes written inline in one expression before it gets a name of its own.
constexpr int longest_inline = 4;

class Writer {
 public:
  Writer(const dag::Function& function, const SymbolTable& names)
      : graph_(function.graph),
        names_(names),
        uses_(graph_.size(), 0),
        text_(graph_.size()),
        length_(graph_.size(), 0) {
    for (const std::uint32_t id : dag::reachable(function))
      for (const Edge& operand : graph_.node(id).operands) ++uses_[operand.node];
    for (const dag::Output& output : function.outputs) ++uses_[output.value.node];
  }

  Code write(const dag::Function& function) {
    for (const std::uint32_t id : dag::reachable(function)) write_node(id);
    for (const dag::Output& output : function.outputs)
      code_.outputs.push_back({output.name, signed_text(output.value)});
    return std::move(code_);
  }

 private:
  static bool is_leaf(Op op) {
    return op == Op::constant || op == Op::symbol || op == Op::sine || op == Op::cosine;
  }

  void write_node(std::uint32_t id) {
    const dag::Node& node = graph_.node(id);
    text_[id] = expression(node);
    if (is_leaf(node.op)) return;
    length_[id] = 1;
    for (const Edge& operand : node.operands) length_[id] += length_[operand.node];
    if (uses_[id] < 2 && length_[id] <= longest_inline) return;
    const std::string name = "t" + std::to_string(code_.temporaries.size());
    code_.temporaries.push_back({name, std::move(text_[id])});
    text_[id] = name;
    length_[id] = 0;
  }

  std::string expression(const dag::Node& node) const {
    switch (node.op) {
      case Op::constant:
        return names_.spelling.number(literal(graph_.constant_of(node)));
      case Op::symbol:
        return names_.symbol(graph_.symbol_of(node));
      case Op::sine:
        return constant_or(sine_literal(graph_.angle_of(node)), names_.sine, node);
      case Op::cosine:
        return constant_or(cosine_literal(graph_.angle_of(node)), names_.cosine, node);
      case Op::sum:
        return sum(node);
      case Op::product:
        return product(node);
      case Op::quotient:
        return factor(node.operands[0]) + " / " + factor(node.operands[1], true);
      case Op::root:
        return names_.spelling.call("sqrt", signed_text(node.operands[0]));
      case Op::arctangent:
        return "atan2(" + signed_text(node.operands[0]) + ", " + signed_text(node.operands[1]) + ")";
    }
    return {};
  }

  template <class Name>
  std::string constant_or(const std::string& literal, const Name& name, const dag::Node& node) const {
    return literal.empty() ? name(graph_.angle_of(node)) : names_.spelling.number(literal);
  }

  bool is_inline(std::uint32_t id, Op op) const { return graph_.node(id).op == op && length_[id] > 0; }

  /// An operand as a factor: sums get parentheses, and products and quotients too where they divide.
  std::string factor(Edge edge, bool divides = false) const {
    const bool compound =
        is_inline(edge.node, Op::sum) ||
        (divides && (is_inline(edge.node, Op::product) || is_inline(edge.node, Op::quotient)));
    const std::string text = compound ? "(" + text_[edge.node] + ")" : text_[edge.node];
    return edge.negative ? "-" + text : text;
  }

  /// A value with its sign; an inline sum takes the sign term by term.
  std::string signed_text(Edge edge) const {
    if (!edge.negative) return text_[edge.node];
    return is_inline(edge.node, Op::sum) ? sum(graph_.node(edge), true) : factor(edge);
  }

  std::string sum(const dag::Node& node, bool negative = false) const {
    std::vector<Edge> terms = node.operands;
    for (Edge& term : terms) term.negative = term.negative != negative;
    const auto positive = std::find_if(terms.begin(), terms.end(), [](Edge e) { return !e.negative; });
    if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
    std::string text = factor(terms.front());
    for (std::size_t i = 1; i < terms.size(); ++i)
      text += (terms[i].negative ? " - " : " + ") + factor({terms[i].node, false});
    return text;
  }

  std::string product(const dag::Node& node) const {
    std::string text = factor(node.operands.front());
    for (std::size_t i = 1; i < node.operands.size(); ++i) text += " * " + factor(node.operands[i]);
    return text;
  }

  const dag::Graph& graph_;
  const SymbolTable& names_;
  std::vector<int> uses_;
  std::vector<std::string> text_;
  std::vector<int> length_;
  Code code_;
};

}  // namespace

const Spelling& cpp_spelling() {
  static const Spelling spelling{[](const std::string& literal) { return "Scalar(" + literal + ")"; }, ".",
                                 [](const std::string& rate) { return "direction(" + rate + ")"; },
                                 [](const std::string& function, const std::string& value) {
                                   // Scalar's own function, or the standard library's for its type.
                                   return "[](const Scalar& operand) { using std::" + function + "; return " +
                                          function + "(operand); }(" + value + ")";
                                 }};
  return spelling;
}

Code straight_code(const dag::Function& function, const SymbolTable& names) {
  return Writer(function, names).write(function);
}

}  // namespace qvgen::emit
