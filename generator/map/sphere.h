// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <qvgen/map/grid.h>

#include "report/chain.h"

namespace qvgen::map {

/// A sphere that the tool point cannot leave, its resolution left open. Its centre is on the first axis.
///
/// From axis to axis the arm's links are rigid, so their lengths add up to a bound: between points of the
/// axes that are chosen where the sum is least. Slides add their travel. Throws std::runtime_error if a slide
/// has no limits and no radius is given.
Sphere sphere_of(const report::Chain& chain, std::optional<double> radius);

}  // namespace qvgen::map
