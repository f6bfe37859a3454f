// SPDX-License-Identifier: MIT
// Both signs of a fork side by side: the scalar of the steps of closed loops. A fork's two solutions share
// all but a sign, so one pass gives both, in the registers of two doubles that every machine has. A fork that
// reads another one's solutions has these in the lanes. A lane has the bits that a double has. Compilers
// without vector types take one number after the other.
#pragma once

#include <cstddef>

#include <qvgen/inverse/angles.h>
#if defined(__GNUC__)
#include <qvgen/inverse/lane_scalar.h>
#else
#include <qvgen/inverse/two_numbers.h>
#endif

namespace qvgen::inverse {

/// The solution for sign 1, and that for sign -1.
#if defined(__GNUC__)
using BothSigns = simd::Lanes<double, simd::Doubles<2>>;
#else
using BothSigns = TwoNumbers;
#endif

/// Returns a number for each lane.
inline BothSigns both_numbers(double first, double second) { return {first, second}; }

/// Returns the branch that both signs begin on.
inline Branch<BothSigns> for_both(const Branch<double>& branch) {
  return {branch.exists, branch.continuum, branch.doubtful, branch.unsure};
}

/// Returns the branch of one lane; of signs, 0 for 1 and 1 for -1.
inline Branch<double> of_sign(const Branch<BothSigns>& both, unsigned sign) {
  const auto is_so = [sign](const Mask<BothSigns>& mask) { return (bits(mask) >> sign & 1U) != 0; };
  return {is_so(both.exists), is_so(both.continuum), is_so(both.doubtful), is_so(both.unsure)};
}

/// True if forks have both of their solutions on the branch around them, and nothing is free or doubtful.
template <class... Forks>
bool are_regular(const Branch<double>& around, const Forks&... forks) {
  const auto is_regular = [](const auto& branch) {
    return branch.exists & !(branch.continuum | branch.unsure);
  };
  return (around.exists && !around.continuum && !around.unsure) && all((is_regular(forks) & ...));
}

/// True if all values of arrays are finite, two at a time: infinity times zero is no number.
template <std::size_t... sizes>
bool are_finite(const double (&... values)[sizes]) {
  BothSigns sum(0);
  const auto add = [&sum](const double* from, std::size_t size) {
    for (std::size_t i = 0; i < size; i += 2) sum = sum + BothSigns(0) * BothSigns::load(from + i);
  };
  (add(values, sizes), ...);
  return all(sum == BothSigns(0));
}

}  // namespace qvgen::inverse

#if defined(__GNUC__)
namespace qvgen::simd {
QVGEN_ARCTANGENTS_OF(inverse::BothSigns)
}  // namespace qvgen::simd
#endif
