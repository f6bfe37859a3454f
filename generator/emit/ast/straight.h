// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "emit/ast/statement.h"

namespace qvgen::emit::ast {

/// Expressions for the leaves of a graph.
struct Leaves {
  std::function<Expression(const std::string& symbol)> symbol;
  std::function<Expression(const dag::Angle&)> sine;
  std::function<Expression(const dag::Angle&)> cosine;
};

/// A graph as straight-line code: constant temporaries in order of use, then one expression per output.
struct Straight {
  struct Value {
    std::string name;
    Expression expression;
  };
  std::vector<Value> temporaries;
  std::vector<Value> outputs;
};

/// Operations written inline in one expression before it gets a name of its own.
inline constexpr int usual_inline = 4;

/// Converts a graph. A value used more than once, or too long to read inline, becomes a temporary `t0, t1,
/// ...`; sums begin with a positive term. The result depends on the graph's structure alone.
Straight straight(const dag::Function& function, const Leaves& leaves, int longest_inline = usual_inline);

/// True if an expression of the code names it.
bool mentions(const Straight& code, const std::string& name);

/// Constants of those names.
Statements declarations(const std::vector<Straight::Value>& values);

}  // namespace qvgen::emit::ast
