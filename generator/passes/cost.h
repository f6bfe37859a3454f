// SPDX-License-Identifier: MIT
#pragma once

#include "dag/counts.h"

namespace qvgen::passes {

/// Costs of the operations of an emitted graph. Only the ratios matter; a sign change is free.
///
/// Between latency and throughput of a scalar double on current x86-64 cores, in multiples of one
/// multiplication: additions and multiplications alike, a division about four, a square root about five of
/// them. A sine with its cosine takes some 10 ns of libm or 12 cycles of a vector pass, an arctangent 25 ns:
/// high enough that a function never asks for more angles than it has joints.
struct CostModel {
  double multiplication = 1;
  double addition = 1;
  double division = 4;
  double root = 5;
  double sine_cosine = 32;  ///< the pair of one angle: paid once, whether one or both are used
  double arctangent = 40;
};

inline double cost(const dag::OperationCounts& counts, const CostModel& model = {}) {
  return model.multiplication * counts.multiplications + model.addition * counts.additions +
         model.division * counts.divisions + model.root * counts.roots +
         model.sine_cosine * counts.sine_cosines + model.arctangent * counts.arctangents;
}

}  // namespace qvgen::passes
