// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "derive/zero_reference.h"
#include "symbolic/program.h"

namespace qvgen::derive {

/// Rotation about a constant unit axis by a linear form of joint variables.
struct Turn {
  symbolic::Vector axis;
  GiNaC::ex angle;
};

/// The rotations of a chain with parallel neighbours merged (theta1 + theta2), and the constant rotation that is left
/// at the end; a home rotation about the last axis has become a part of the last angle.
struct TurnSequence {
  std::vector<Turn> turns;
  symbolic::Quaternion home;
};
TurnSequence turn_sequence(const ZeroReferenceChain& chain);

/// True where turns i, i+1, i+2 are an Euler triple: first and last axis parallel, the middle one perpendicular.
bool is_euler_triple(const std::vector<Turn>& turns, std::size_t i);

/// The triple in closed form with half-angle sums, four products (q_a(x) b = b q_a(-x) for b perpendicular to a):
/// cos(beta/2) q_a(alpha + gamma) + sin(beta/2) b q_a(gamma - alpha).
symbolic::Quaternion euler_triple(const Turn& first, const Turn& second, const Turn& third);

/// v turned about the turn's axis, full-angle sine and cosine, components along the axis left alone.
symbolic::Vector turned(const Turn& turn, const symbolic::Vector& v);

}  // namespace qvgen::derive
