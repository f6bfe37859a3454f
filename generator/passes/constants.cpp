// SPDX-License-Identifier: MIT
#include "passes/constants.h"

#include <algorithm>
#include <optional>

#include <cln/float.h>
#include <cln/real.h>

#include "dag/rebuild.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"

namespace qvgen::passes {
namespace {

using cln::cl_R;
using dag::Edge;
using dag::Op;

cln::float_format_t format() { return cln::float_format(75); }

cl_R decimal(const exact::Number& number) {
  cl_R sum = 0;
  for (const auto& [radicand, coefficient] : number.terms())
    sum = sum + coefficient * cln::sqrt(cln::cl_float(radicand, format()));
  return sum;
}

/// The value of a node that no variable and no symbol of the description enters.
std::optional<cl_R> value_of(const dag::Graph& graph, const dag::Node& node) {
  switch (node.op) {
    case Op::constant:
      return decimal(graph.constant_of(node));
    case Op::symbol:
      if (const auto value = exact::named_value(graph.symbol_of(node))) return *value;
      return std::nullopt;
    case Op::sine:
    case Op::cosine: {
      const auto radians = exact::radians(graph.angle_of(node));
      if (!radians) return std::nullopt;
      const cln::cl_F angle = cln::cl_float(*radians, format());
      return node.op == Op::sine ? cln::sin(angle) : cln::cos(angle);
    }
    default:
      return std::nullopt;
  }
}

class Folder {
 public:
  Edge operator()(const dag::Graph& from, const dag::Node& node, const std::vector<Edge>& operands,
                  dag::Graph& to) {
    if (operands.empty()) {
      const Edge leaf = dag::copy_node(from, node, operands, to);
      if (const auto value = value_of(from, node)) remember(leaf, *value);
      return leaf;
    }
    std::vector<Edge> constants;
    std::vector<Edge> others;
    for (const Edge& operand : operands) (known(operand) ? constants : others).push_back(operand);
    const bool many = node.op == Op::sum || node.op == Op::product;
    if (many && constants.size() > 1) {
      cl_R total = node.op == Op::sum ? 0 : 1;
      for (const Edge& each : constants)
        total = node.op == Op::sum ? total + *known(each) : total * *known(each);
      others.push_back(constant(total, to));
      return node.op == Op::sum ? to.sum(std::move(others)) : to.product(std::move(others));
    }
    if (others.empty() && node.op == Op::quotient)
      return constant(*known(operands[0]) / *known(operands[1]), to);
    if (others.empty() && node.op == Op::root)
      return constant(cln::sqrt(cln::cl_float(*known(operands[0]), format())), to);
    // A division by a constant is a product.
    if (node.op == Op::quotient && known(operands[1]))
      return to.product({operands[0], constant(cln::recip(*known(operands[1])), to)});
    const bool has_number = std::any_of(operands.begin(), operands.end(),
                                        [&](const Edge& operand) { return to.is_constant(operand); });
    return (has_number ? dag::copy_node : dag::copy_node_as_is)(from, node, operands, to);
  }

 private:
  std::optional<cl_R> known(Edge edge) const {
    const auto place = values_.find(edge.node);
    if (place == values_.end()) return std::nullopt;
    return edge.negative ? -place->second : place->second;
  }
  void remember(Edge edge, const cl_R& value) { values_[edge.node] = edge.negative ? -value : value; }

  Edge constant(const cl_R& value, dag::Graph& to) {
    const auto rational = exact::rational_near(value);
    const bool negative = cln::minusp(value);
    const Edge size =
        rational ? to.constant(cln::abs(*rational)) : to.symbol(exact::name_of_number(cln::abs(value)));
    const Edge edge = negative ? -size : size;
    remember(edge, value);
    return edge;
  }

  std::map<std::uint32_t, cl_R> values_;
};

bool has_named_constants(const dag::Function& function) {
  const std::vector<std::uint32_t> nodes = dag::reachable(function);
  return std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t id) {
    const dag::Node& node = function.graph.node(id);
    if (node.op == Op::symbol) return is_named_constant(function.graph.symbol_of(node));
    if (node.op != Op::sine && node.op != Op::cosine) return false;
    const auto& terms = function.graph.angle_of(node).terms;
    return std::any_of(terms.begin(), terms.end(),
                       [](const auto& term) { return is_named_constant(term.first); });
  });
}

/// A function's single result, built in another graph.
Edge append(const dag::Function& meaning, dag::Graph& to) {
  std::vector<Edge> images(meaning.graph.size());
  for (const std::uint32_t id : dag::reachable(meaning)) {
    const dag::Node& node = meaning.graph.node(id);
    std::vector<Edge> operands;
    for (const Edge& operand : node.operands)
      operands.push_back(operand.negative ? -images[operand.node] : images[operand.node]);
    images[id] = dag::copy_node(meaning.graph, node, operands, to);
  }
  const Edge result = meaning.outputs.front().value;
  return result.negative ? -images[result.node] : images[result.node];
}

/// An angle with sums in place of some of its variables.
dag::Angle in_terms_of(const dag::Angle& angle, const std::map<std::string, std::vector<Multiple>>& sums) {
  dag::Angle result{{}, angle.pi};
  for (const auto& [variable, coefficient] : angle.terms) {
    const auto sum = sums.find(variable);
    if (sum == sums.end()) {
      result = result + dag::Angle{{{variable, coefficient}}, 0};
      continue;
    }
    for (const Multiple& term : sum->second)
      result = result + dag::Angle{{{term.symbol, coefficient * term.factor}}, 0};
  }
  return result;
}

}  // namespace

bool is_named_constant(const std::string& symbol) { return exact::named_value(symbol).has_value(); }

dag::Function fold_constants(const dag::Function& function) {
  if (!has_named_constants(function)) return function;
  Folder folder;
  const dag::Function folded =
      dag::rebuild(function, [&](const auto& from, const auto& node, const auto& operands, auto& to) {
        return folder(from, node, operands, to);
      });
  return dag::rebuild(folded, dag::copy_node_as_is);
}

dag::Function substitute(const dag::Function& function,
                         const std::map<std::string, dag::Function>& meanings) {
  if (meanings.empty()) return function;
  return dag::rebuild(function, [&](const auto& from, const auto& node, const auto& operands, auto& to) {
    if (node.op == Op::symbol) {
      const auto meaning = meanings.find(from.symbol_of(node));
      if (meaning != meanings.end()) return append(meaning->second, to);
    }
    return dag::copy_node(from, node, operands, to);
  });
}

dag::Function with_other_zeros(const dag::Function& function, const std::map<std::string, OtherZero>& zeros) {
  if (zeros.empty()) return function;
  const auto moved = [&](const dag::Angle& angle) {
    dag::Angle sum{{}, angle.pi};
    for (const auto& [variable, coefficient] : angle.terms) {
      const auto zero = zeros.find(variable);
      const bool reversed = zero != zeros.end() && zero->second.reversed;
      sum = sum + dag::Angle{{{variable, reversed ? -coefficient : coefficient}}, 0};
      if (zero != zeros.end()) sum = sum + coefficient * zero->second.phase;
    }
    return sum;
  };
  return dag::rebuild(function, [&](const auto& from, const auto& node, const auto& operands, auto& to) {
    if (node.op == Op::sine) return to.sine(moved(from.angle_of(node)));
    if (node.op == Op::cosine) return to.cosine(moved(from.angle_of(node)));
    const Edge copy = dag::copy_node_as_is(from, node, operands, to);
    if (node.op != Op::symbol) return copy;
    const auto zero = zeros.find(from.symbol_of(node));
    return zero != zeros.end() && zero->second.reversed ? -copy : copy;
  });
}

dag::Function substitute(const dag::Function& function,
                         const std::map<std::string, std::vector<Multiple>>& sums) {
  if (sums.empty()) return function;
  const auto in_graph = [](const std::vector<Multiple>& terms, dag::Graph& to) {
    std::vector<Edge> edges;
    for (const Multiple& term : terms)
      edges.push_back(to.product({to.constant(exact::Number(term.factor)), to.symbol(term.symbol)}));
    return edges.size() == 1 ? edges.front() : to.sum(std::move(edges));
  };
  return dag::rebuild(function, [&](const auto& from, const auto& node, const auto& operands, auto& to) {
    if (node.op == Op::symbol) {
      const auto sum = sums.find(from.symbol_of(node));
      if (sum != sums.end()) return in_graph(sum->second, to);
    }
    if (node.op != Op::sine && node.op != Op::cosine) return dag::copy_node(from, node, operands, to);
    const dag::Angle angle = in_terms_of(from.angle_of(node), sums);
    return node.op == Op::sine ? to.sine(angle) : to.cosine(angle);
  });
}

}  // namespace qvgen::passes
