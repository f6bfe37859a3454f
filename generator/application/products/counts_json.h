// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "application/optimise.h"

namespace qvgen::application {

nlohmann::ordered_json to_json(const dag::OperationCounts& counts);
dag::OperationCounts counts_from_json(const nlohmann::ordered_json& json);

/// The entry of one function in operation_counts.json.
nlohmann::ordered_json to_json(const Optimised& optimised);

/// "24 multiplications, 12 additions, 5 sine/cosine pairs"
std::string describe(const dag::OperationCounts& counts);

}  // namespace qvgen::application
