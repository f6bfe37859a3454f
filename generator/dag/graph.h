// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "dag/angle.h"
#include "exact/number.h"
#include "exact/trigonometry.h"

namespace qvgen::dag {

enum class Op : std::uint8_t { constant, symbol, sine, cosine, sum, product, quotient, root, arctangent };

/// A node or its negative. A sign change is free, so it lives on the edge and x, -x are one node.
struct Edge {
  std::uint32_t node = 0;
  bool negative = false;
  Edge operator-() const { return {node, !negative}; }
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// Operands: sum, product n-ary (n >= 2; edges of a product are positive); quotient numerator, denominator;
/// root one; arctangent y, x. Leaves have none; their payload is an index into the graph's tables.
struct Node {
  Op op;
  std::uint32_t payload = 0;
  std::vector<Edge> operands;
  std::uint64_t key = 0;  ///< structural hash: equal in every run for equal expressions
};

/// Hash-consed expression graph. Nodes are appended, never changed; operands precede their users.
///
/// Every builder normalises: constants folded, 0 and 1 gone, like terms collected, operands in structural
/// order, signs pulled out. Nested sums and products stay as they were built. Equal structure is equal Edge.
class Graph {
 public:
  Edge constant(const exact::Number& value);
  Edge symbol(const std::string& name);
  Edge sine(const Angle& angle);
  Edge cosine(const Angle& angle);
  Edge sum(std::vector<Edge> operands);
  Edge product(std::vector<Edge> operands);
  /// A sum or product of exactly these operands: put in order and signs pulled out, but nothing folded,
  /// collected or flattened. For a pass that has decided what is shared (the builders would turn (2 x) y into
  /// 2 x y).
  Edge as_is(Op op, std::vector<Edge> operands);
  Edge quotient(Edge numerator, Edge denominator);
  Edge root(Edge radicand);
  Edge arctangent(Edge y, Edge x);

  [[nodiscard]] const Node& node(std::uint32_t id) const { return nodes_[id]; }
  [[nodiscard]] const Node& node(Edge edge) const { return nodes_[edge.node]; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
  [[nodiscard]] const exact::Number& constant_of(const Node& node) const { return constants_[node.payload]; }
  [[nodiscard]] const std::string& symbol_of(const Node& node) const { return symbols_[node.payload]; }
  [[nodiscard]] const Angle& angle_of(const Node& node) const { return angles_[node.payload]; }
  [[nodiscard]] bool is_constant(Edge edge) const { return nodes_[edge.node].op == Op::constant; }
  /// Exact value of a constant edge, its sign included.
  [[nodiscard]] exact::Number value_of(Edge edge) const;
  [[nodiscard]] bool is_zero(Edge edge) const;
  [[nodiscard]] bool is_one(Edge edge) const;

 private:
  /// coefficient * base, or coefficient * product of factors where those are given.
  struct Term {
    exact::Number coefficient;
    Edge base;
    std::vector<Edge> factors;
  };
  [[nodiscard]] Term term_of(Edge edge) const;
  Edge scaled(const exact::Number& coefficient, Edge base);
  Edge trigonometric(const exact::TrigonometricValue& value);
  Edge intern(Op op, std::uint32_t payload, std::uint64_t payload_key, std::vector<Edge> operands);
  [[nodiscard]] bool precedes(Edge a, Edge b) const;

  std::vector<Node> nodes_;
  std::vector<exact::Number> constants_;
  std::vector<std::string> symbols_;
  std::vector<Angle> angles_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> index_;
};

struct Output {
  std::string name;
  Edge value;
};

/// A graph with its named results: what every pass takes and returns.
struct Function {
  Graph graph;
  std::vector<Output> outputs;
};

}  // namespace qvgen::dag
