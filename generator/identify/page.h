// SPDX-License-Identifier: MIT
// The findings of an identification as one page of HTML, with plots, that needs no network.
#pragma once

#include <string>

#include "identify/identification.h"

namespace qvgen::identify {

/// Returns the page: torques measured and predicted of each joint, spectra of the residuals, parameters with
/// their intervals, the full set, and what was not told and why.
std::string page(const model::Robot& robot, const Identification& found);

}  // namespace qvgen::identify
