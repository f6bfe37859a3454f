// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/lower.h"
#include "derive/inverse/problem.h"

namespace qvgen::verify {

struct InverseCertificate {
  int poses = 0;
  int solutions = 0;
  [[nodiscard]] std::string text() const;
};

/// Runs a plan in sixty digits at random joints and geometry, from a pose of the described arm to rows of its
/// joints: the sampled ones must be among them and every row must give the pose back, both to fifty digits,
/// by a forward kinematics that multiplies the description's displacements and shares nothing with the
/// derivation. Throws CertificateError otherwise. What the task does not ask for is not given and not
/// compared, and of candidates some may miss the pose.
InverseCertificate certify_inverse(const derive::inverse::Problem& problem,
                                   const derive::inverse::LoweredPlan& plan, int poses);

}  // namespace qvgen::verify
