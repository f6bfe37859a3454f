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

/// A column as a combination of others, by their indices. A coefficient that contains lengths or angles is
/// not known.
using Relation = std::map<std::size_t, std::optional<Coefficient>>;

/// True if all coefficients are known: the column can be left out for every geometry.
bool is_known(const Relation& relation);

/// Finds which columns of a matrix depend on others over all motions of one geometry. The function's outputs
/// are the matrix column by column; columns are gone through in the given order, and one that depends on
/// those before it gets a relation to independent ones. Works in 80 digits at random motions. A coefficient
/// is known if two geometries have the same.
std::vector<std::optional<Relation>> relations_of_columns(const model::Robot& robot,
                                                          const Formulation& formulation, std::size_t rows,
                                                          const std::vector<std::size_t>& order);

}  // namespace qvgen::derive::dynamics
