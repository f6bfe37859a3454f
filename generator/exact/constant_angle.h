// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "exact/angle.h"
#include "exact/number.h"

namespace qvgen::exact {

/// Cosine and sine of one angle.
struct CosineSine {
  Number cosine = 1, sine;
  friend bool operator==(const CosineSine& a, const CosineSine& b) {
    return a.cosine == b.cosine && a.sine == b.sine;
  }
};

/// Returns sine and cosine of the sum of two angles, and of a multiple.
CosineSine then(const CosineSine& a, const CosineSine& b);
CosineSine times(CosineSine base, long count);

/// A constant angle that is no known part of a turn but has an exact sine and cosine, such as that of an axis
/// (3/5, 0, 4/5): a term of an Angle by this name, "atan2(3/5,4/5)", which no symbol can have.
std::string constant_angle(const CosineSine& value);

/// Returns sine and cosine by the name of a constant; nothing for other names.
std::optional<CosineSine> constant_angle(const std::string& name);

/// Returns sine and cosine of an angle without a variable, if they are exact.
std::optional<CosineSine> value_of(const Angle& angle);

/// The angle in radians as a rational number, to 70 digits.
cln::cl_RA radians(const CosineSine& value);
/// Returns an angle without a variable in radians; nothing if it has one.
std::optional<cln::cl_RA> radians(const Angle& angle);

}  // namespace qvgen::exact
