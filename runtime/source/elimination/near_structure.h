// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/elimination/arm.h>

namespace qvgen::inverse::elimination {

/// True if three axes in a row are nearly parallel or nearly meet in one point, but not quite: by less than a
/// few hundred-thousandths of the arm's size, as a wrist that is spherical but for some micrometres. Next to
/// singular poses such an arm has solutions that few digits tell apart.
bool nearly_has_structure(const Description& arm, double size);

}  // namespace qvgen::inverse::elimination
