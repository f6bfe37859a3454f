// SPDX-License-Identifier: MIT
// Blocks of inverse kinematics stand once, in the C++ runtime. `in_c` reads a header of it and prints the
// same functions in C, in the same order of operations, from which the other languages come: a double in the
// place of `Scalar`, a bool of its mask; a reference becomes a pointer or a copy, a pair of numbers in braces
// a call of `rotor`.
#pragma once

#include <string>

#include "emit/blocks/parser.h"
#include "emit/blocks/runtime/words.h"

namespace qvgen::emit::blocks::runtime {

/// Reads C, then headers of the runtime that call it. Later ones see what earlier ones define.
class Reader {
 public:
  /// Takes definitions of C as known: they stand for those of the runtime that have their names. Fields at
  /// the beginning of a struct for which there are constants `most_FIELD` are its sizes.
  void read_c(const File& file);
  /// Returns the other definitions of a header in C. Throws NotInSubset.
  std::string in_c(const File& header);

 private:
  Scope scope_;
  Known known_;
};

}  // namespace qvgen::emit::blocks::runtime
