// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::report {

/// A function as a generated header declares it.
struct Declaration {
  std::string name;
  std::string signature;             ///< without its template line
  std::vector<std::string> comment;  ///< paragraphs
};

/// The declarations of a generated header that have a comment, in order.
std::vector<Declaration> declarations_in(const std::string& header);

}  // namespace qvgen::report
