// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "exact/angle.h"
#include "exact/number.h"

namespace qvgen::exact {

/// +-sin(angle), +-cos(angle) of a canonical angle, or an exact number.
struct TrigonometricValue {
  bool negative = false;
  bool is_sine = false;
  Angle angle;
  std::optional<Number> number;
};

/// sin and cos with the sign of the angle and whole quarter turns taken out; the remaining multiple of pi
/// lies in [-1/4, 1/4], and a remaining constant angle that is a multiple of 15 degrees has become a number.
TrigonometricValue normalised_sine(const Angle& angle);
TrigonometricValue normalised_cosine(const Angle& angle);

/// Exact sin(turns * pi) where turns is a multiple of 1/12; nothing otherwise.
std::optional<Number> exact_sine(const cln::cl_RA& turns);

}  // namespace qvgen::exact
