// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "symbolic/algebra.h"

namespace qvgen::symbolic {

/// The one GiNaC symbol of that name: real, shared by every derivation of this process.
GiNaC::symbol symbol(const std::string& name);

GiNaC::ex to_symbolic(const model::Expression& expression);
Vector to_symbolic(const model::Vector3& vector);
/// Turns first to last, then the translation: x -> R x + t.
Pair to_symbolic(const model::Displacement& displacement);

/// Motion alone: rotation about (thesis 1.9) or translation along (1.10) the joint's axis.
Pair motion(const model::Joint& joint);

}  // namespace qvgen::symbolic
