// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "compare/comparison.h"

namespace qvgen::compare {

nlohmann::ordered_json to_json(const Row& row);
Row row_from_json(const nlohmann::ordered_json& json);

}  // namespace qvgen::compare
