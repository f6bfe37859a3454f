// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::emit::c {

/// Returns C in double as C in float: the type, the functions of <math.h>, limits of <float.h>, and literals,
/// each the float that is nearest to its double, as C++ converts them. Comments stay, and so does what has no
/// fraction and no exponent. Nothing is computed in double then (-Wdouble-promotion has nothing to say), and
/// the order of operations is the same.
std::string in_single_precision(const std::string& code);

}  // namespace qvgen::emit::c
