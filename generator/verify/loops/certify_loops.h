// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/lower.h"
#include "derive/loops/assembly_plan.h"

namespace qvgen::verify {

struct LoopCertificate {
  int inputs = 0;
  int assemblies = 0;
  [[nodiscard]] std::string text() const;
};

/// Runs a plan of closed loops in sixty digits, from the given joints of mechanisms that Newton's steps have
/// assembled: each assembly closes every loop to fifty digits, and the one that was sampled is among them.
/// Throws CertificateError otherwise, and std::domain_error if no joints are found at which the loops close.
LoopCertificate certify_loops(const model::Mechanism& mechanism, const derive::loops::AssemblyPlan& assembly,
                              const derive::inverse::LoweredPlan& plan, int inputs);

}  // namespace qvgen::verify
