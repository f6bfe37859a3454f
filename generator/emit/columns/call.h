// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/columns/signature.h"

namespace qvgen::emit::columns {

/// Lines of C that call a function for one configuration: arguments are `in[i]`, pointers to numbers in the
/// order of the signature; results go to `out[i]`, by `put(to, from, a, b, c)` of an array of a x b x c, and
/// `put_whole(to, from, count)` of whole numbers.
std::vector<std::string> lines_of_call(const blocks::Unit& unit, const Signature& signature);

}  // namespace qvgen::emit::columns
