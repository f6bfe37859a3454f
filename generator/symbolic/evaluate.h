// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "exact/point.h"
#include "symbolic/program.h"

namespace qvgen::symbolic {

/// A linear form of symbols and pi; throws std::domain_error for any other argument of a sine or cosine.
exact::Angle to_angle(const GiNaC::ex& argument);

/// The rational number that a GiNaC number is; throws std::domain_error otherwise.
cln::cl_RA to_rational(const GiNaC::ex& number);

/// The outputs of a program at an exact point, computed by GiNaC itself, step by step and without the
/// expression graph: what a certificate holds the graph against.
std::vector<exact::Number> evaluate(const Program& program, const exact::ExactPoint& point);

}  // namespace qvgen::symbolic
