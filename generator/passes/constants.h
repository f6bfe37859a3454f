// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "dag/graph.h"

namespace qvgen::passes {

/// True if a symbol is a constant whose name says its value (exact/named_constant.h): arithmetic on such
/// symbols and numbers alone is done at generation.
bool is_named_constant(const std::string& symbol);

/// Does all arithmetic on numbers, named constants and sines of constant angles: what it gives is a number or
/// a named constant. Functions without named constants come back as they are.
dag::Function fold_constants(const dag::Function& function);

/// Puts the meanings in place of symbols: each is a function with one output.
dag::Function substitute(const dag::Function& function, const std::map<std::string, dag::Function>& meanings);

/// Variable in terms of another one with its name: the other one, negated if `reversed`, plus a constant
/// angle.
struct OtherZero {
  bool reversed = false;
  dag::Angle phase;
};
/// Puts those in place of variables. Nothing else changes, and no operation is added outside of angles.
dag::Function with_other_zeros(const dag::Function& function, const std::map<std::string, OtherZero>& zeros);

/// Term of a linear combination of symbols.
struct Multiple {
  std::string symbol;
  cln::cl_RA factor;
};
/// Puts sums of multiples of other symbols in place of symbols, in angles too.
dag::Function substitute(const dag::Function& function,
                         const std::map<std::string, std::vector<Multiple>>& sums);

}  // namespace qvgen::passes
