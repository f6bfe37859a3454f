// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// Three revolute axes through one point, neighbours not parallel. Axes may depend on nothing but numbers.
bool is_wrist(const Screw& first, const Screw& middle, const Screw& last, const Scope& scope);

/// The wrist's last step: rotation = e1 e2 e3 as a quaternion in terms of named values. (INVERSE: U = F4ᵀ R
/// F6.)
void solve_wrist(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                 const symbolic::Quaternion& rotation);

}  // namespace qvgen::derive::inverse
