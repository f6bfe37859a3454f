// SPDX-License-Identifier: MIT
// Words of a header of the C++ runtime as words of C, but for what only types tell: references, methods,
// products of rotors and braces, which the parser of runtime.cpp reads. A header keeps to functions over
// numbers and small structs, with one type `Scalar`. Example:
//
//     template <typename Scalar>                                      static double share(double a, bool b)
//     Scalar share(const Scalar& a, const Mask<Scalar>& b)            { return (a) / 2.0; }
//     { return Scalar(a) / Scalar(2); }
//
// A flag among the parameters of a template is the first parameter in C. Methods become functions first
// (methods.h). Where the namespace `polynomial` has a function, it is the one for doubles: C has no other.
//
// Sizes among the parameters of a template are known when C++ compiles, and in C when it runs: they are whole
// numbers in front of the parameters, but for those that a parameter has as its fields. A named array becomes
// a struct with room for `most_SIZE` entries, a constant of the robot's C. Types keep their sizes, by which
// the parser finds those of a call:
//
//     template <typename Scalar, std::size_t rows>                    typedef struct Vector {
//     using Vector = std::array<Scalar, rows>;                          double of[most_rows];
//                                                                     } Vector;
//     template <typename Scalar, std::size_t rows>                    static double first(
//     Scalar first(const Vector<Scalar, rows>& v) { return v[0]; }        int rows, const Vector<rows>& v)
//     {...}
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/lexer.h"

namespace qvgen::emit::blocks::runtime {

using Tokens = std::vector<Token>;

/// Facts of one header that later ones need.
struct Known {
  std::map<std::string, std::vector<std::pair<std::string, std::string>>>
      defaults;                                           ///< by struct: field, value
  std::set<std::string> flagged;                          ///< functions whose template has a flag
  std::map<std::string, std::vector<std::string>> sized;  ///< by struct: the sizes of its template
  std::set<std::string> arrays;                           ///< structs that stand for arrays
  std::map<TypeRef, Expressions> sizes;                   ///< by type as it is written: its sizes
  std::set<std::string> with_fields;                      ///< structs of C that have their sizes as fields
};

/// Returns the name in C of a function of which C++ has several, by the number of its parameters and the type
/// of the first.
std::string overload_in_c(const std::string& name, std::size_t count, bool is_of_rotor);

/// Returns the definitions of a header in C's words but for those whose name is `skipped`. Throws
/// NotInSubset.
Tokens words_of(const File& header, const std::function<bool(const std::string&)>& skipped, Known& known);

}  // namespace qvgen::emit::blocks::runtime
