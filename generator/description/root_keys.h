// SPDX-License-Identifier: MIT
// Keys that may stand at the root of a description in TOML.
#pragma once

#include <string>
#include <vector>

namespace qvgen::description {

const std::vector<std::string>& root_keys();

}  // namespace qvgen::description
