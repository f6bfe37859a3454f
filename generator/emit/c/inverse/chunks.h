// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::emit::c {

/// A C source of which only what its public functions need is left: types, constants and static functions
/// that nothing reaches from there go. Compilers warn of them.
std::string needed(const std::string& source);

/// Returns the part of a C source that a function needs, and behind it that function, which is given as text.
std::string needed_by(const std::string& function, const std::string& source);

}  // namespace qvgen::emit::c
