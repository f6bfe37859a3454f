// SPDX-License-Identifier: MIT
#pragma once

#include "symbolic/program.h"

namespace qvgen::derive {

/// Name of the rate of a joint variable, d/dt of it, as a symbol of the derivations.
std::string rate_name(const std::string& variable);

/// Derivatives of the values of a program by the chain rule, step by step, so that they stay as shared as the
/// values.
///
/// `seeds` gives the derivative of each symbol that varies: {theta2: 1} for the partial derivative, {theta1:
/// rate of theta1, ...} for the derivative by time. The derivatives of all steps so far become steps of the
/// program.
class Rates {
 public:
  Rates(symbolic::Program& program, const GiNaC::exmap& seeds);

  /// Derivative of an expression in the symbols and steps known at construction; not named.
  [[nodiscard]] GiNaC::ex operator()(const GiNaC::ex& value) const;
  [[nodiscard]] symbolic::Vector operator()(const symbolic::Vector& value) const;
  [[nodiscard]] symbolic::Quaternion operator()(const symbolic::Quaternion& value) const;

 private:
  GiNaC::exmap rates_;
};

}  // namespace qvgen::derive
