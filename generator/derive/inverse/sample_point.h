// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <ginac/ginac.h>

namespace qvgen::derive::inverse {

/// Values of symbols, and of expressions in them: exact as long as nothing irrational stands in them, else to
/// GiNaC's digits.
class SamplePoint {
 public:
  void set(const GiNaC::ex& symbol, const GiNaC::ex& value);
  [[nodiscard]] const GiNaC::ex& at(const GiNaC::ex& symbol) const { return symbols_.at(symbol); }
  /// Nothing if a symbol has no value.
  [[nodiscard]] std::optional<GiNaC::numeric> value(const GiNaC::ex& expression) const;

 private:
  [[nodiscard]] GiNaC::numeric compute(const GiNaC::ex& expression) const;
  [[nodiscard]] GiNaC::numeric compute_once(const GiNaC::ex& expression) const;

  GiNaC::exmap symbols_;
  mutable GiNaC::exmap functions_;  ///< sines and the like, each computed once
};

}  // namespace qvgen::derive::inverse
