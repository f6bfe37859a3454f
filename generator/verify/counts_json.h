// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "dag/counts.h"

namespace qvgen::verify {

nlohmann::ordered_json to_json(const dag::OperationCounts& counts);
dag::OperationCounts counts_from_json(const nlohmann::ordered_json& json);

/// "24 multiplications, 12 additions, 5 sine/cosine pairs"
std::string describe(const dag::OperationCounts& counts);

}  // namespace qvgen::verify
