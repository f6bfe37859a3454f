// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "derive/dynamics/formulation.h"

/// Gathers the results of a recursion, one for every joint of the chain, for the joints that follow none
/// (model/followers.h). Arms without followers come back as they are.
namespace qvgen::derive::dynamics {

/// Rates and accelerations of followers in terms of their leaders'; angles and lengths stay.
Formulation in_rates_of_leaders(const model::Robot& robot, Formulation formulation);

/// C^T x.
std::vector<Scalar> gathered(const model::Robot& robot, const std::vector<Scalar>& forces, dag::Graph& graph);

/// C^T M C of the entries that are there, by coordinates (model/coordinates.h).
using Entries = std::map<std::pair<std::size_t, std::size_t>, Scalar>;
Entries gathered(const model::Robot& robot, const Entries& entries, dag::Graph& graph);
/// Gathers a symmetric matrix, of which only the upper triangle is there, before and after.
Entries gathered_symmetric(const model::Robot& robot, const Entries& upper, dag::Graph& graph);

}  // namespace qvgen::derive::dynamics
