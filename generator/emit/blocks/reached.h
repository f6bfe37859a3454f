// SPDX-License-Identifier: MIT
// Definitions of C that public functions need, found by the words of each: the blocks are one text for all
// robots, and compilers warn of static functions that nobody calls.
#pragma once

#include <string>

namespace qvgen::emit::blocks {

/// Returns a source of C without the types, constants and static functions that no public function reaches.
/// Definitions keep their order, comments and lines. One blank line stands between two of them. Throws
/// NotInSubset.
std::string reached(const std::string& source);

/// Returns a public function, given as text, behind what it needs of a source. Throws NotInSubset.
std::string reached_by(const std::string& function, const std::string& source);

}  // namespace qvgen::emit::blocks
