// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dag/counts.h"
#include "dag/graph.h"
#include "derive/form.h"
#include "verify/certificate.h"

namespace qvgen::optimise {

/// A quantity to generate, whatever it was derived by: what forward kinematics, Jacobians and dynamics become
/// before the passes.
struct Quantity {
  std::string name;  ///< of the generated function
  struct Form {
    std::string name;
    dag::Function function;  ///< with suggestions for the search among its outputs
  };
  std::vector<Form> forms;  ///< they compete; all have the same outputs
  /// Residuals of the outputs' values, all of which must be zero.
  verify::Residuals residuals;
  std::vector<std::string> outputs = {};  ///< their names; none if the forms alone say them
  /// An output for each symbol "$0", ... of the forms that stands for a constant. With it, what can be
  /// computed before the configuration is known is split off from the function.
  std::optional<dag::Function> constants = {};
  dag::IsFree is_free = {};          ///< symbols on which arithmetic is free
  std::set<std::string> whole = {};  ///< symbols that stand in angles with whole coefficients only
  /// From the arm that the forms are of to the one that `residuals` knows, without an operation more; none if
  /// it is the same.
  std::function<dag::Function(const dag::Function&)> in_terms_of_description = {};
};

/// A derived quantity with its forms as graphs.
Quantity lowered(const derive::Quantity& quantity);

}  // namespace qvgen::optimise
