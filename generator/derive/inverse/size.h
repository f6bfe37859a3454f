// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "derive/inverse/plan.h"

namespace qvgen::derive::inverse {

/// How much there is to write: symbols, numbers and operations of an expression as it stands.
std::size_t nodes(const GiNaC::ex& value);
/// Counts the nodes of all programs of a plan.
std::size_t nodes(const Plan& plan);

}  // namespace qvgen::derive::inverse
