// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace qvgen::pipeline {

/// Writes JSON for people and for `diff`: an object or list that holds no further one stands on one line.
std::string lines_of_json(const nlohmann::ordered_json& json);

}  // namespace qvgen::pipeline
