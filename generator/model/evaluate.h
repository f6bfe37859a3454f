// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <stdexcept>

#include <cln/real.h>

#include "model/robot.h"

namespace qvgen::model {

/// Why an expression has no value: a zero denominator, the root of a negative number, an unbound symbol.
struct EvaluationError : std::domain_error {
  enum class Reason { division_by_zero, negative_root, unbound_symbol };
  EvaluationError(Reason why, const std::string& what) : std::domain_error(what), reason(why) {}
  Reason reason;
};

using Bindings = std::map<std::string, cln::cl_R>;

/// Value of an expression: exact (a rational) as long as no irrational function occurs, else a float of
/// `evaluation_digits` decimals. For checks of the description, not for certificates.
inline constexpr unsigned long evaluation_digits = 100;
cln::cl_R evaluate(const Expression& expression, const Bindings& bindings = {});
double to_double(const cln::cl_R& value);

/// Zero, or below what the float's digits can tell from zero.
bool vanishes(const cln::cl_R& value);

/// The value itself if it was computed without rounding.
std::optional<cln::cl_RA> rational_value(const cln::cl_R& value);

/// The defaults of a robot's parameters; those without one are left out.
Bindings default_bindings(const Robot& robot);

}  // namespace qvgen::model
