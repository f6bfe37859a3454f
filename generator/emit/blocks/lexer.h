// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/blocks/unit.h"

/// Words of C: what the parser reads. Preprocessor lines are left out, and so is what is for C++ alone.
namespace qvgen::emit::blocks {

struct Token {
  enum class Kind { name, number, text, sign, end };
  Kind kind = Kind::end;
  std::string text = {};
  int line = 0;
  std::vector<std::string> comment = {};  ///< lines of comment in front of it, without slashes
  std::string behind = {};                ///< comment behind it on its line
};

/// Tokens of a file, one of kind `end` at the end.
std::vector<Token> tokens_of(const File& file);

/// The message with file, line and the line's text.
NotInSubset error_at(const File& file, int line, const std::string& what);

}  // namespace qvgen::emit::blocks
