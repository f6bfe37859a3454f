// SPDX-License-Identifier: MIT
// C in double or in float, from one source.
//
// Bounds of what rounding may do are written in double, as digits(1e-7): so many of the type's digits as 1e-7
// is of those of double. In double that is 1e-7, in float the power 23/52 of it, 8.01e-4. Numbers near the
// end of the range are written so as range(1e50), in float the power 127/1023 of it.
#pragma once

#include <string>

namespace qvgen::emit::c {

/// Returns C without the marks, as it is compiled in double and translated to other languages.
std::string in_double_precision(const std::string& code);

/// Returns C in double as C in float: the type, the functions of <math.h>, limits of <float.h>, and literals,
/// each the float that is nearest to its double, as C++ converts them. Comments stay, and so does what has no
/// fraction and no exponent. Nothing is computed in double then (-Wdouble-promotion has nothing to say), and
/// the order of operations is the same.
std::string in_single_precision(const std::string& code);

/// Returns C in double that says the numbers of C in float, by names of double: what other languages
/// translate where their numbers are floats.
std::string with_single_numbers(const std::string& code);

}  // namespace qvgen::emit::c
