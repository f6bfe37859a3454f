// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"
#include "derive/inverse/screw.h"

namespace qvgen::derive::inverse {

/// The element of M_i = N_i along a direction, i the joint of the axis; none if the direction, which is that
/// of the zero pose, is not one of the coordinates in which the model gives that axis.
Elements element_along(const Screw& axis, const symbolic::Vector& direction, const Scope& scope);

/// The two elements across an axis; none if it is not one of the coordinates.
Elements elements_across(const Screw& axis, const Scope& scope);

/// The whole vector; the whole quaternion.
Elements vector_elements(const Screw& axis);
Elements quaternion_elements(const Screw& axis);

}  // namespace qvgen::derive::inverse
