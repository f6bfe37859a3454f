// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/view.h>

/// Sines and cosines in lanes of each set, for the tests.
namespace qvgen::lane_sines {

/// Two rows: sines and cosines of the angles in the only row given. For as many as fill all lanes.
template <class Set, class Scalar>
struct LaneSines {
  static void compute(const Batch<const Scalar>& angles, const Batch<Scalar>& result);
};

}  // namespace qvgen::lane_sines
