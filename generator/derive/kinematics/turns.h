// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "derive/kinematics/zero_reference.h"
#include "symbolic/program.h"

namespace qvgen::derive {

/// Rotation about a constant unit axis by a linear form of joint variables.
struct Turn {
  symbolic::Vector axis;
  GiNaC::ex angle;
};

/// The rotations of a chain with parallel neighbours merged (theta1 + theta2), and the constant rotation that
/// is left at the end; a home rotation about the last axis has become a part of the last angle.
struct TurnSequence {
  std::vector<Turn> turns;
  symbolic::Quaternion home;
};
TurnSequence turn_sequence(const ZeroReferenceChain& chain);

/// True where turns i, i+1, i+2 are an Euler triple: first and last axis parallel, the middle one
/// perpendicular.
bool is_euler_triple(const std::vector<Turn>& turns, std::size_t i);

/// The triple in closed form with half-angle sums, four products (q_a(x) b = b q_a(-x) for b perpendicular to
/// a): cos(beta/2) q_a(alpha + gamma) + sin(beta/2) b q_a(gamma - alpha).
symbolic::Quaternion euler_triple(const Turn& first, const Turn& second, const Turn& third);

/// The whole product in closed form with angle sums about one direction: every turn is about +-axis or about
/// a perpendicular, so each choice of cosine or sine of the perpendicular turns leaves one rotation about the
/// axis: sum over the choices of (product of cosines and sines) * (product of unit vectors) * q_axis(sum of
/// +-angles). Nothing where a turn is oblique to the axis, or more than `most` turns are perpendicular.
std::optional<symbolic::Quaternion> angle_sum_product(const std::vector<Turn>& turns,
                                                      const symbolic::Vector& axis, std::size_t most);

/// v turned about the turn's axis, full-angle sine and cosine, components along the axis left alone.
symbolic::Vector turned(const Turn& turn, const symbolic::Vector& v);

}  // namespace qvgen::derive
