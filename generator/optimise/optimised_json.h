// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "optimise/optimise.h"

namespace qvgen::optimise {

/// The entry of a function in operation_counts.json.
nlohmann::ordered_json to_json(const Optimised& optimised);

}  // namespace qvgen::optimise
