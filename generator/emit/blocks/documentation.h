// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// Comments of C in the words of a language that returns its results: "Returns how many there are" goes, NULL
/// gets the language's name, code of C is left out.
namespace qvgen::emit::blocks {

struct DocWords {
  std::string robot;  ///< whose name in front of others goes
  std::string null;   ///< "`None`"
  std::size_t width = 100;
  bool returns_last = false;  ///< the comment is a function's that returns its last parameter
};

/// Lines of a comment without marks, broken anew.
std::vector<std::string> documentation(const std::vector<std::string>& doc, const DocWords& words);

}  // namespace qvgen::emit::blocks
