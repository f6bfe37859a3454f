// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "verify/inverse/real_backend.h"

namespace qvgen::verify {

struct Row {
  std::vector<Real> q;
  int branch = 0;
  bool continuum = false;
};

/// Tolerance of certificates of inverse kinematics, which compute with sixty digits.
inline constexpr double fifty_digits = 1e-50;

/// Outputs of a function at values of its symbols, in sixty digits.
Values outputs(const dag::Function& function, const Values& values);

/// Runs a lowered plan step by step in sixty digits, with the building blocks of the runtime: all solutions.
/// `values`: of the names that the plan's target program reads, geometry and the pose.
/// Throws CertificateError if the range test says something else of a circle than its step.
std::vector<Row> execute(const derive::inverse::LoweredPlan& plan, Values values);

}  // namespace qvgen::verify
