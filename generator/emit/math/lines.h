// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"

namespace qvgen::emit {

/// A formula in pieces that fit a line, broken before terms, those of the outermost sum if that will do.
/// `used` is what stands before it on the first line, in characters.
std::vector<std::string> broken(const std::string& formula, Notation notation, std::size_t used = 0);

/// left = right, broken into lines of text, or of an align* environment.
std::vector<std::string> equation_lines(const std::string& left, const std::string& right, Notation notation);

/// Breaks a formula with or without " = " into lines.
std::vector<std::string> formula_lines(const std::string& formula, Notation notation);

/// Words without formulas as LaTeX takes them.
std::string latex_words(const std::string& words);

/// Roughly how wide a formula is, in characters of the notation's output.
std::size_t width(const std::string& formula, Notation notation);

}  // namespace qvgen::emit
