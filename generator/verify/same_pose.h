// SPDX-License-Identifier: MIT
#pragma once

#include "canonical/arm.h"

namespace qvgen::verify {

/// Throws CertificateError unless the canonical arm has the described arm's tool pose, to 34 digits at random
/// points.
void certify_same_pose(const model::Robot& described, const canonical::Arm& arm);

}  // namespace qvgen::verify
