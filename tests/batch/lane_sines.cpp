// SPDX-License-Identifier: MIT
#include "lane_sines.h"

#include <qvgen/batch/run.h>

namespace qvgen::lane_sines {

template <class Set, class Scalar>
[[gnu::flatten]] void LaneSines<Set, Scalar>::compute(const Batch<const Scalar>& angles,
                                                      const Batch<Scalar>& result) {
  using Lane = batch::Lanes<Scalar, Set>;
  batch::run<Lane, 2>(
      result,
      [](auto& write, const auto& angle) {
        const auto both = sines_and_cosines<Lane>(angle(0));
        write(both.sine[0]);
        write(both.cosine[0]);
      },
      batch::Input<Scalar, 1>{angles});
}

#if defined(QVGEN_BATCH_LANES)
template struct LaneSines<batch::Compiled, double>;
template struct LaneSines<batch::Compiled, float>;
#endif

}  // namespace qvgen::lane_sines
