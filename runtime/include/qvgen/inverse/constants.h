// SPDX-License-Identifier: MIT
#pragma once

// Numbers of the blocks of inverse kinematics that are no tolerances. C has them from here: its blocks say
// constant_NAME where `double NAME = ...` stands below.

namespace qvgen::inverse::constant {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double whole_turn = 6.283185307179586476925;
inline constexpr double half_turn = 0x1.921fb54442d18p+1;
inline constexpr double quarter_turn = 0x1.921fb54442d18p+0;
inline constexpr double eighth_turn = 0x1.921fb54442d18p-1;
/// Digits that a quarter of a turn has beyond a double.
inline constexpr double beyond_quarter_turn = 0x1.1a62633145c07p-54;

// Choices of free joints (nearby.h): by the golden angle, by a 16th of a turn, and by half of these.

inline constexpr double golden_angle = 2.399963229728653;
inline constexpr double golden_cosine = -0x1.798869e0de833p-1;
inline constexpr double golden_sine = 0x1.59d9dd253cc13p-1;
inline constexpr double half_golden_cosine = 0x1.731267372626dp-2;
inline constexpr double half_golden_sine = 0x1.dd335a962dc90p-1;
inline constexpr double sixteenth_cosine = 0x1.d906bcf328d46p-1;
inline constexpr double sixteenth_sine = 0x1.87de2a6aea963p-2;
inline constexpr double half_sixteenth_cosine = 0x1.f6297cff75cb0p-1;
inline constexpr double half_sixteenth_sine = 0x1.8f8b83c69a60ap-3;

// Square roots of primes, whose multiples spread poses nearby evenly.

inline constexpr double root_of_2 = 1.4142135623730951;
inline constexpr double root_of_3 = 1.7320508075688772;
inline constexpr double root_of_5 = 2.23606797749979;
inline constexpr double root_of_7 = 2.6457513110645906;
inline constexpr double root_of_11 = 3.3166247903554;
inline constexpr double root_of_13 = 3.605551275463989;
inline constexpr double root_of_17 = 4.123105625617661;

// Series of the arctangent (arctangent.h), minimax: for tangents up to 0.45, and up to tan(pi/8).

inline constexpr double arctangent_0 = -0x1.55555555554d3p-2;
inline constexpr double arctangent_1 = 0x1.999999998721ap-3;
inline constexpr double arctangent_2 = -0x1.2492491d4e0a2p-3;
inline constexpr double arctangent_3 = 0x1.c71c6eeb5ad85p-4;
inline constexpr double arctangent_4 = -0x1.745cc35dc5ea5p-4;
inline constexpr double arctangent_5 = 0x1.3b0d9caeb1e12p-4;
inline constexpr double arctangent_6 = -0x1.10c699c0d341ap-4;
inline constexpr double arctangent_7 = 0x1.dd1589af82d9ep-5;
inline constexpr double arctangent_8 = -0x1.947d0a96686b7p-5;
inline constexpr double arctangent_9 = 0x1.23ffc268de3f2p-5;
inline constexpr double arctangent_10 = -0x1.f962b3a8b22c7p-7;
inline constexpr double short_arctangent_0 = -0x1.5555555555317p-2;
inline constexpr double short_arctangent_1 = 0x1.9999999949573p-3;
inline constexpr double short_arctangent_2 = -0x1.2492490573282p-3;
inline constexpr double short_arctangent_3 = 0x1.c71c65cc4b9efp-4;
inline constexpr double short_arctangent_4 = -0x1.745bc2e136756p-4;
inline constexpr double short_arctangent_5 = 0x1.3afc30ebd6b1bp-4;
inline constexpr double short_arctangent_6 = -0x1.100504f5a18b1p-4;
inline constexpr double short_arctangent_7 = 0x1.d252ee2a38bc9p-5;
inline constexpr double short_arctangent_8 = -0x1.65109d731968bp-5;
inline constexpr double short_arctangent_9 = 0x1.5c382b132ec64p-6;

}  // namespace qvgen::inverse::constant
