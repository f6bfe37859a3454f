// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "compare/formulation.h"
#include "dag/counts.h"
#include "dag/graph.h"
#include "exact/number.h"
#include "model/robot.h"

namespace qvgen::compare {

/// The function with what its unknown entries are.
dag::Function with_entries(const dag::Function& function, const dag::Function& entries);

/// Values of a quantity's definition at random exact points.
struct Definition {
  std::vector<std::string> outputs;
  std::vector<std::vector<exact::Number>> values;  ///< at each point, of each output
};
Definition definition_of(What what, const model::Robot& robot);

/// Compares a function with the definition, tolerance zero. A quaternion is compared as a matrix: it and its
/// negative are the same. Throws verify::CertificateError.
void certify(const dag::Function& function, const Definition& definition, const std::string& name);

/// Compares two functions in sixty digits, named constants (exact/named_constant.h) at their values: what
/// folding them has made of a function that was certified before. Throws verify::CertificateError.
void certify_same(const dag::Function& folded, const dag::Function& certified, const std::string& name);

}  // namespace qvgen::compare
