// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "derive/dynamics/formulation.h"

namespace qvgen::derive::dynamics {

/// A rational number, times gravity or not.
struct Coefficient {
  cln::cl_RA factor;
  bool of_gravity = false;
  friend bool operator==(const Coefficient&, const Coefficient&) = default;
};

/// A column as a combination of others, by their indices.
using Relation = std::map<std::size_t, Coefficient>;

/// Finds which columns of a matrix depend on others over all motions of one geometry. The function's outputs
/// are the matrix column by column; columns are gone through in the given order, and one that depends on
/// those before it gets a relation to those kept. Works in 80 digits at random motions, for two geometries.
/// Throws std::domain_error where a coefficient differs between them by more than a factor of gravity.
std::vector<std::optional<Relation>> relations_of_columns(const model::Robot& robot,
                                                          const Formulation& formulation, std::size_t rows,
                                                          const std::vector<std::size_t>& order);

}  // namespace qvgen::derive::dynamics
