// SPDX-License-Identifier: MIT
#include "passes/search/selection_state.h"

#include <utility>

namespace qvgen::passes::search_detail {

SelectionState::SelectionState(const Network& network, Selection selection)
    : network_(network),
      selection_(std::move(selection)),
      uses_(network.size()),
      angle_references_(network.angle_costs.size(), 0) {
  for (std::uint32_t node = 0; node < network.size(); ++node) {
    const std::uint32_t count = network.choice_count(node);
    if (count > 0) uses_[node].chosen = &network.choices[network.first[node] + selection_[node]];
    uses_[node].has_alternatives = count > 1;
  }
  for (const std::uint32_t output : network.outputs) acquire(output);
}

std::vector<const Choice*> SelectionState::choices() const {
  std::vector<const Choice*> result;
  for (const Use& use : uses_) result.push_back(use.chosen);
  return result;
}

void SelectionState::acquire(std::uint32_t node) {
  Use& use = uses_[node];
  if (use.references++ != 0) return;
  if (use.has_alternatives) {
    use.place = static_cast<std::uint32_t>(candidates_.size());
    candidates_.push_back(node);
  }
  acquire_operands(*use.chosen);
}

void SelectionState::release(std::uint32_t node) {
  Use& use = uses_[node];
  if (--use.references != 0) return;
  if (use.has_alternatives) {
    const std::uint32_t last = candidates_.back();
    candidates_[use.place] = last;
    uses_[last].place = use.place;
    candidates_.pop_back();
  }
  release_operands(*use.chosen);
}

void SelectionState::acquire_operands(const Choice& choice) {
  cost_ += choice.cost;
  if (choice.angle >= 0) {
    const auto angle = static_cast<std::size_t>(choice.angle);
    if (angle_references_[angle]++ == 0) cost_ += network_.angle_costs[angle];
  }
  for (std::uint32_t i = 0; i < choice.operand_count; ++i) acquire(choice.operands[i]);
}

void SelectionState::release_operands(const Choice& choice) {
  cost_ -= choice.cost;
  if (choice.angle >= 0) {
    const auto angle = static_cast<std::size_t>(choice.angle);
    if (--angle_references_[angle] == 0) cost_ -= network_.angle_costs[angle];
  }
  for (std::uint32_t i = 0; i < choice.operand_count; ++i) release(choice.operands[i]);
}

void SelectionState::select(std::uint32_t node, std::uint32_t choice) {
  Use& use = uses_[node];
  const Choice& before = *use.chosen;
  selection_[node] = choice;
  use.chosen = &network_.choices[network_.first[node] + choice];
  if (use.references == 0) return;
  acquire_operands(*use.chosen);
  release_operands(before);
}

}  // namespace qvgen::passes::search_detail
