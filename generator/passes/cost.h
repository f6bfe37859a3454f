// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen::passes {

/// What an operation of the emitted graph costs. Only the ratios matter; a sign change is free.
///
/// The defaults are latencies of a scalar double on a current x86-64 core in multiples of one multiplication,
/// rounded: additions and multiplications alike, a division about four, a square root about five of them; a
/// sine with its cosine and an arctangent are library calls.
struct CostModel {
  double multiplication = 1;
  double addition = 1;
  double division = 4;
  double root = 5;
  double sine_cosine = 16;  ///< the pair of one angle: paid once, whether one or both are used
  double arctangent = 20;
};

}  // namespace qvgen::passes
