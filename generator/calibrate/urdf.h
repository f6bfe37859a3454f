// SPDX-License-Identifier: MIT
// The calibrated arm as a URDF: the input's own text, in which the joints sit elsewhere.
#pragma once

#include "calibrate/calibration.h"
#include "description/reader.h"
#include "description/xml/urdf_origin.h"

namespace qvgen::calibrate {

/// Returns the motion of a place in a URDF: its turns about the fixed axes, then the shift.
Rigid<double> rigid_of(const description::xml::UrdfOrigin& origin);

/// Returns the URDF `text` with new origins on the way from base to tip. Axes change only where the file has
/// them rounded. A tip without a fixed joint of its own gets one, to the link TIP_calibrated. `head`: lines
/// of a comment. Throws std::runtime_error for text that is no URDF, and for followers at a distance.
std::string calibrated_urdf(const std::string& text, const description::ReadOptions& options,
                            const Calibration& calibration, const std::string& head);

}  // namespace qvgen::calibrate
