// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tree.h"

namespace qvgen::test::sources {

/// One sign or one factor of an expression read from left to right, its brackets left out: "a*(b - c)" is
/// a, b, -, c. The tree that a token points into must outlive it.
struct Token {
  char sign = ' ';  ///< +, - or p for ±, m for ∓; blank for a factor
  const Tree* leaf = nullptr;
};
std::vector<Token> tokens_of(const Tree& tree);

/// True if the two have signs and factors at the same places, so that they may differ by their brackets.
bool same_without_brackets(const Tree& a, const Tree& b);

/// Returns the printed signs and factors in the brackets of the right form. The two must be the same without
/// brackets.
Tree rebracketed(const Tree& printed, const Tree& right);

}  // namespace qvgen::test::sources
