// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

namespace qvgen::derive {

/// One way to compute a quantity. Several forms of one quantity compete; all have the same outputs.
struct Form {
  std::string name;
  symbolic::Program program;
};

/// A quantity to generate: its competing forms, and the plain definition that each must equal exactly.
struct Quantity {
  std::string name;
  std::vector<Form> forms;
  symbolic::Program definition;
};

}  // namespace qvgen::derive
