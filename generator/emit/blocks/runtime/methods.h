// SPDX-License-Identifier: MIT
// Takes functions out of structs, still in words of C++, so that a block with methods can be read as C. The
// object becomes a parameter; what makes an object is named after its struct. Example:
//
//     struct Place {                                struct Place { double x; };
//       double x;                                   void move(Place& self, double by) { self.x += by; }
//       void move(double by) { x += by; }           Place origin_place() { ... }
//       static Place origin() { ... }
//     };
#pragma once

#include "emit/blocks/runtime/words.h"

namespace qvgen::emit::blocks::runtime {

/// Returns a header's words with functions in the place of its methods, static functions and constructors.
/// Throws NotInSubset if a bracket is not closed.
Tokens without_methods(const File& header, Tokens words);

}  // namespace qvgen::emit::blocks::runtime
