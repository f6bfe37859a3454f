// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "optimise/optimise.h"

namespace qvgen::optimise {

/// The entry of a function in operation_counts.json. Of one whose constants are split off also the counts of
/// its set-up part and the choices of its formulation, in words.
nlohmann::ordered_json to_json(const Optimised& optimised, const std::string& choices = "");

}  // namespace qvgen::optimise
