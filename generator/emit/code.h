// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/ast/printer.h"
#include "emit/ast/straight.h"

namespace qvgen::emit {

/// Straight-line code in a language: constant temporaries in order of use, then one expression per output.
struct Code {
  struct Value {
    std::string name;
    std::string expression;
  };
  std::vector<Value> temporaries;
  std::vector<Value> outputs;
};

/// One statement that assigns an expression: "target = other_target" and the expression.
struct Assignment {
  std::string targets;
  std::string expression;
};

/// The assignments of outputs to their targets; equal expressions are assigned together, where the first
/// stands.
std::vector<Assignment> assignments(const std::vector<std::string>& targets,
                                    const std::vector<Code::Value>& outputs);

Code code_of(const ast::Straight& code, const ast::Printer& language);

/// Writes a graph down.
Code straight_code(const dag::Function& function, const ast::Leaves& leaves, const ast::Printer& language,
                   int longest_inline = ast::usual_inline);

}  // namespace qvgen::emit
