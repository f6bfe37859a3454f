// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "dag/graph.h"

namespace qvgen::emit {

/// Spelling of expressions, where languages differ.
struct Spelling {
  std::function<std::string(const std::string& literal)> number;  ///< "Scalar(2)"
  std::string member;                                             ///< behind what holds constants: "."
  std::function<std::string(const std::string& rate)> direction;  ///< 1, -1 or 0
  /// sqrt, sin or cos of a value, where no declaration in front has named the function.
  std::function<std::string(const std::string& function, const std::string& value)> call;
};
const Spelling& cpp_spelling();

/// How the leaves of a graph are written in the generated function.
struct SymbolTable {
  std::function<std::string(const std::string& symbol)> symbol;
  std::function<std::string(const dag::Angle&)> sine;
  std::function<std::string(const dag::Angle&)> cosine;
  Spelling spelling = cpp_spelling();
};

/// Straight-line code, C++ unless the table spells another language: constant temporaries in order of use,
/// then one expression per output.
struct Code {
  struct Value {
    std::string name;
    std::string expression;
  };
  std::vector<Value> temporaries;
  std::vector<Value> outputs;
};

/// Writes a function down. A value used more than once, or too long to read inline, becomes a temporary `t0,
/// t1, ...`; sums are written with a positive term first. The text depends on the graph's structure alone.
Code straight_code(const dag::Function& function, const SymbolTable& names);

}  // namespace qvgen::emit
