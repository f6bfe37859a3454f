// SPDX-License-Identifier: MIT
#pragma once

#include <ginac/ginac.h>

#include "dag/graph.h"

namespace qvgen::emit {

/// A value as a function of one output, simplified, certified to be the same.
dag::Function tidy(const GiNaC::ex& value);

/// True if all angles are sums of symbols with whole coefficients: what derive::CirclePolynomials can take.
bool has_whole_angles(const GiNaC::ex& value);

/// Tidies a value, with or without products of sines and cosines turned into sines and cosines of sums of
/// angles, whichever is shorter.
dag::Function tidy_in_sums(const GiNaC::ex& value);

}  // namespace qvgen::emit
