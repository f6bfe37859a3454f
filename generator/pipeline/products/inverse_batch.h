// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "model/robot.h"

namespace qvgen::pipeline {

/// Template values of inverse_batch.cpp, and of what batch.h says of it.
nlohmann::json inverse_batch_values(const model::Robot& described);

}  // namespace qvgen::pipeline
