// SPDX-License-Identifier: MIT
// Text for what cannot be told: "the offset of link 3: only together with the offset of link 2".
#pragma once

#include "calibrate/setup.h"

namespace qvgen::calibrate {

/// Returns one sentence for each group of parameters that depend on the same others.
std::vector<std::string> sentences(const std::vector<Parameter>& parameters,
                                   const std::vector<Dependence>& dependent);

/// Returns "a, b and c".
std::string listed(const std::vector<std::string>& names);

}  // namespace qvgen::calibrate
