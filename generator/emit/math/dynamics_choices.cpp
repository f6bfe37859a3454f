// SPDX-License-Identifier: MIT
#include "emit/math/dynamics_choices.h"

#include "derive/dynamics/chain.h"
#include "emit/math/notation.h"

namespace qvgen::emit {
namespace {

using derive::dynamics::FormulationOptions;

/// The length that is the unit, or nothing.
std::string unit_text(const model::Robot& robot, const FormulationOptions& choices, bool numbers_too) {
  if (!choices.convention.unit) return {};
  dag::Graph graph;
  const auto chain = derive::dynamics::make_chain(robot, graph);
  const dag::Edge unit = unit_candidates(chain)[*choices.convention.unit].in(graph);
  if (graph.is_constant(unit) && !numbers_too) return {};
  return formula(graph, unit, Notation::text);
}

}  // namespace

std::string choices_text(const model::Robot& robot, const FormulationOptions& choices) {
  const std::string unit = unit_text(robot, choices, true);
  std::string text = unit.empty() ? "no unit of length" : "unit of length " + unit;
  for (const auto& [link, component] : choices.convention.masses)
    text += ", mass on link " + std::to_string(link + 1) + (component == 0 ? " for h_x" : " for h_y");
  return text + (choices.last_link_unrotated ? ", last link unrotated" : "");
}

std::string symbolic_unit_text(const model::Robot& robot, const FormulationOptions& choices) {
  return unit_text(robot, choices, false);
}

}  // namespace qvgen::emit
