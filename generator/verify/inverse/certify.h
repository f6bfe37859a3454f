// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/lower.h"
#include "model/robot.h"

namespace qvgen::verify {

struct InverseCertificate {
  int poses = 0;
  int solutions = 0;
  [[nodiscard]] std::string text() const;
};

/// Runs a plan in sixty digits at random joints and geometry: the sampled joints must be among its solutions
/// and every solution must give the pose back, both to fifty digits, by a forward kinematics that multiplies
/// the description's displacements and shares nothing with the derivation. Throws CertificateError otherwise.
/// What the task does not ask for is not compared, and of candidates some may miss the pose.
InverseCertificate certify_inverse(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                                   int poses, model::Task task = model::Task::pose);

}  // namespace qvgen::verify
