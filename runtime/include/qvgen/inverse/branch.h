// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/boundary.h>

/// State of the branch that a sequence of blocks follows: it exists or not, a free joint was chosen on it or
/// not, and rounding may have decided so or not.
namespace qvgen::inverse {

/// State of the branch that a sequence of blocks follows.
template <typename Scalar>
struct Branch {
  Mask<Scalar> exists{true};      ///< false: no such solution
  Mask<Scalar> continuum{false};  ///< true: an angle was free and has been chosen
  Mask<Scalar> doubtful{
      false};  ///< true: rounding may have decided what exists, on this branch or on one before

  Mask<Scalar> unsure{false};  ///< doubtful on this branch alone, in passes near singular poses too

  /// Back to a fork; doubts stay.
  void resume(const Branch& fork) {
    exists = fork.exists;
    continuum = fork.continuum;
    unsure = fork.unsure;
  }
  void doubt(const Mask<Scalar>& condition) {
    doubtful = doubtful | (exists & condition);
    unsure = unsure | condition;
  }
  /// Takes the choice where an angle is free and the equation holds, and the result of a regular block
  /// elsewhere.
  void take(const Mask<Scalar>& is_free, const Mask<Scalar>& holds, const Branch& regular) {
    doubtful = doubtful | (exists & is_free) | regular.doubtful;
    unsure = unsure | is_free | regular.unsure;
    exists = (is_free & exists & holds) | ((!is_free) & regular.exists);
    continuum = continuum | (exists & is_free);
  }
};

}  // namespace qvgen::inverse
