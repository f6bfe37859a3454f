// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "dag/graph.h"
#include "symbolic/program.h"

namespace qvgen::verify {

/// A generated graph is not equal to its definition.
class CertificateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Compares every output of the graph with the definition at `points` random exact points (exact/point.h),
/// tolerance zero. The definition is evaluated by GiNaC and never passes through the graph. A wrong identity
/// of degree d survives one point with a probability below d/1000 (Schwartz-Zippel), n points with its n-th
/// power. Unit quaternions are compared with their sign: forms of one quantity agree on it.
void certify(const dag::Function& function, const symbolic::Program& definition, int points,
             const std::string& what);

}  // namespace qvgen::verify
