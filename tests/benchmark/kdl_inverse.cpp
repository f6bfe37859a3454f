// SPDX-License-Identifier: MIT
#include "kdl_inverse.h"

namespace comparison {

KdlInverse::KdlInverse(const KDL::Chain& chain)
    : chain_(chain),
      forward_(chain_),
      velocity_(chain_),
      newton_(chain_, forward_, velocity_, 100, accuracy),
      levenberg_marquardt_(chain_, accuracy),
      start_(chain.getNrOfJoints()),
      result_(chain.getNrOfJoints()) {}

}  // namespace comparison
