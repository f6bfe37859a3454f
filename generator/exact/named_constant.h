// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <cln/rational.h>
#include <cln/real.h>

namespace qvgen::exact {

/// Real constants that are no rational numbers, and angles that are no multiple of a right angle, stand in
/// expressions as symbols whose name says their value: `number(0.866...)`, `turn(1/6)` (a multiple of pi),
/// `angle(3927/2500)` (radians). No symbol of a description can have such a name. A derivation treats them as
/// any symbol, so that nothing is multiplied out; whoever needs the value asks for it here.

/// A number, given in more than 60 digits.
std::string name_of_number(const cln::cl_R& value);
/// An angle in radians, given in more than 60 digits: by its multiple of pi or its rational value if it has
/// one of moderate length.
std::string name_of_angle(const cln::cl_R& radians);

/// The value to 60 digits of what has been named here; nothing for any other name.
std::optional<cln::cl_RA> named_value(const std::string& name);

/// The simplest rational number next to a value given in `digits` digits, if it has a moderate length (far
/// shorter than chance would give); nothing for others.
std::optional<cln::cl_RA> rational_near(const cln::cl_R& value);

}  // namespace qvgen::exact
