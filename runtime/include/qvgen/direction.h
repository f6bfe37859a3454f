// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen {

/// Returns the sign of a joint rate, for Coulomb friction: 1, -1, or 0 at rest (and for NaN). Scalars without
/// branches have their own.
template <class Scalar>
Scalar direction(const Scalar& rate) {
  return Scalar(0) < rate ? Scalar(1) : rate < Scalar(0) ? Scalar(-1) : Scalar(0);
}

}  // namespace qvgen
