// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// Three revolute axes through one point, neighbours not parallel. Axes may depend on nothing but numbers.
bool is_wrist(const Screw& first, const Screw& middle, const Screw& last, const Scope& scope);

/// The wrist's step: rotation = e1 e2 e3 as a quaternion in terms of named values, by the half angles in the
/// elements of U = F4ᵀ R F6, R the rotation and F the frames of first and last axis with their normals.
/// `choice`: cosine and sine of the first angle where it is free, of a wrist behind which further steps come.
void solve_wrist(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                 const symbolic::Quaternion& rotation, const Scope::Turn* choice = nullptr);
/// Solves a wrist behind which further steps come; its first angle is the seed's if it is free.
void solve_wrist_of_seed(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                         const symbolic::Quaternion& rotation);

}  // namespace qvgen::derive::inverse
