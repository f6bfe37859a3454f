// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::emit::c {

/// A C source of which only what its public functions need is left: types, constants and static functions
/// that nothing reaches from there go. Compilers warn of them.
std::string needed(const std::string& source);

}  // namespace qvgen::emit::c
