// SPDX-License-Identifier: MIT
#pragma once

#include "emit/blocks/lexer.h"

/// Brackets of all kinds in a list of words.
namespace qvgen::emit::blocks::runtime {

/// Returns the place of the bracket that closes the one at a place. Throws NotInSubset if there is none.
inline std::size_t closing(const File& file, const std::vector<Token>& words, std::size_t from) {
  int depth = 0;
  for (std::size_t i = from; i < words.size(); ++i) {
    const std::string& word = words[i].text;
    depth += word == "(" || word == "{" || word == "["   ? 1
             : word == ")" || word == "}" || word == "]" ? -1
                                                         : 0;
    if (depth == 0) return i;
  }
  throw error_at(file, words[from].line, "a bracket is not closed");
}

}  // namespace qvgen::emit::blocks::runtime
