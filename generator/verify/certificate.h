// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "exact/point.h"
#include "symbolic/program.h"

namespace qvgen::verify {

/// A generated graph is not equal to its definition.
class CertificateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Residuals of a function's outputs at an exact point: their values less those of the definition, all zero
/// if it is right.
using Residuals = std::function<std::vector<exact::Number>(const exact::ExactPoint&,
                                                           const std::vector<exact::Number>& values)>;

/// Compares a function with what it must be at `points` random exact points (exact/point.h), tolerance zero.
/// A wrong identity of degree d survives one point with a probability below d/1000 (Schwartz-Zippel), n
/// points with its n-th power. `constants`: an output for each of the function's symbols "$0", ..., if it has
/// any. `whole`: symbols that stand in angles with whole coefficients only. Throws CertificateError.
void certify(const dag::Function& function, const dag::Function& constants, const Residuals& residuals,
             const std::set<std::string>& whole, int points, const std::string& what);

/// Certifies a function by its definition, which is evaluated by GiNaC and never passes through the graph.
/// Unit quaternions are compared with their sign: forms of one quantity agree on it.
void certify(const dag::Function& function, const symbolic::Program& definition, int points,
             const std::string& what);

/// Returns the residuals to a definition's outputs.
Residuals residuals_of(const symbolic::Program& definition);

}  // namespace qvgen::verify
