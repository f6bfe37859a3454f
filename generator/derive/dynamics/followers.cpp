// SPDX-License-Identifier: MIT
#include "derive/dynamics/followers.h"

#include "model/coordinates.h"
#include "model/followers.h"
#include "passes/constants.h"

namespace qvgen::derive::dynamics {
namespace {

Scalar times(const cln::cl_RA& ratio, const Scalar& value, dag::Graph& graph) {
  return ratio == 1 ? value : Scalar(graph, graph.constant(exact::Number(ratio))) * value;
}

/// One for each coordinate of the base and each joint; nothing of the base follows.
std::vector<std::vector<model::Share>> shares_of_coordinates(const model::Robot& robot) {
  const std::size_t base = model::base_motions(robot);
  std::vector<std::vector<model::Share>> result;
  for (std::size_t k = 0; k < base; ++k) result.push_back({{k, 1}});
  for (std::vector<model::Share> row : model::shares(robot)) {
    for (model::Share& share : row) share.driven += base;
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace

Formulation in_rates_of_leaders(const model::Robot& robot, Formulation formulation) {
  std::map<std::string, std::vector<passes::Multiple>> rates;
  for (const model::Joint& joint : robot.joints) {
    for (const auto& [leader, ratio] : joint.follows) {
      rates[velocity_of(joint.variable)].push_back({velocity_of(leader), ratio});
      rates[acceleration_of(joint.variable)].push_back({acceleration_of(leader), ratio});
    }
    // A joint of several leaders has no Coulomb friction, whose direction would not be linear in theirs.
    if (joint.follows.size() == 1) {
      const auto& [leader, ratio] = joint.follows.front();
      rates[direction_of(joint.variable)] = {{direction_of(leader), cln::signum(ratio)}};
    }
  }
  formulation.function = passes::substitute(formulation.function, rates);
  return formulation;
}

std::vector<Scalar> gathered(const model::Robot& robot, const std::vector<Scalar>& forces,
                             dag::Graph& graph) {
  return model::gathered(robot, forces, [&](const Scalar& sum, const cln::cl_RA& ratio, const Scalar& force) {
    return sum + times(ratio, force, graph);
  });
}

Entries gathered(const model::Robot& robot, const Entries& entries, dag::Graph& graph) {
  if (!model::has_followers(robot)) return entries;
  const std::vector<std::vector<model::Share>> shares = shares_of_coordinates(robot);
  Entries result;
  for (const auto& [place, value] : entries)
    for (const model::Share& row : shares[place.first])
      for (const model::Share& column : shares[place.second]) {
        Scalar& sum = result[{row.driven, column.driven}];
        sum = sum + times(row.ratio * column.ratio, value, graph);
      }
  return result;
}

Entries gathered_symmetric(const model::Robot& robot, const Entries& upper, dag::Graph& graph) {
  if (!model::has_followers(robot)) return upper;
  Entries whole = upper;
  for (const auto& [place, value] : upper) whole[{place.second, place.first}] = value;
  Entries result = gathered(robot, whole, graph);
  std::erase_if(result, [](const auto& entry) { return entry.first.first > entry.first.second; });
  return result;
}

}  // namespace qvgen::derive::dynamics
