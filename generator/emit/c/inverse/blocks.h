// SPDX-License-Identifier: MIT
// Functions of inverse kinematics in C that all robots share. Equations are read from headers of the C++
// runtime (emit/blocks/runtime); what C has of its own (rows, trackers, passes near singular poses) stands in
// templates/c/inverse.
#pragma once

#include <string>

namespace qvgen::emit::c {

/// Returns the functions in an order in which each is defined before it is called.
const std::string& inverse_blocks();

}  // namespace qvgen::emit::c
