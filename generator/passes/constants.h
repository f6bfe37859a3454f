// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>

#include "dag/graph.h"

namespace qvgen::passes {

/// Whether a symbol is a constant whose name says its value (exact/named_constant.h): arithmetic on such
/// symbols and numbers alone is done at generation.
bool is_named_constant(const std::string& symbol);

/// Does all arithmetic on numbers, named constants and sines of constant angles: what it gives is a number or
/// a named constant. Functions without named constants come back as they are.
dag::Function fold_constants(const dag::Function& function);

/// Puts the meanings in place of symbols: each is a function with one output.
dag::Function substitute(const dag::Function& function, const std::map<std::string, dag::Function>& meanings);

/// Adds a constant angle to variables wherever they stand in a sine or cosine.
dag::Function add_phases(const dag::Function& function, const std::map<std::string, dag::Angle>& phases);

/// Puts multiples of other symbols in place of symbols, in angles too.
struct Multiple {
  std::string symbol;
  cln::cl_RA factor;
};
dag::Function substitute(const dag::Function& function, const std::map<std::string, Multiple>& multiples);

}  // namespace qvgen::passes
