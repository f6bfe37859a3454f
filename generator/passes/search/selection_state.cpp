// SPDX-License-Identifier: MIT
#include "passes/search/selection_state.h"

#include <utility>

namespace qvgen::passes::search_detail {

SelectionState::SelectionState(const Network& network, Selection selection)
    : network_(network),
      selection_(std::move(selection)),
      references_(network.size(), 0),
      angle_references_(network.angle_costs.size(), 0),
      place_(network.size(), 0),
      visited_(network.size(), 0) {
  for (const std::uint32_t output : network.outputs) acquire(output);
}

void SelectionState::acquire(std::uint32_t node) {
  if (references_[node]++ != 0) return;
  if (network_.choice_count(node) > 1) {
    place_[node] = static_cast<std::uint32_t>(candidates_.size());
    candidates_.push_back(node);
  }
  acquire_operands(chosen(node));
}

void SelectionState::release(std::uint32_t node) {
  if (--references_[node] != 0) return;
  if (network_.choice_count(node) > 1) {
    const std::uint32_t last = candidates_.back();
    candidates_[place_[node]] = last;
    place_[last] = place_[node];
    candidates_.pop_back();
  }
  release_operands(chosen(node));
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
  const Choice& before = chosen(node);
  selection_[node] = choice;
  if (references_[node] == 0) return;
  acquire_operands(chosen(node));
  release_operands(before);
}

bool SelectionState::on_cycle(std::uint32_t node) {
  ++visit_;
  stack_.assign(1, node);
  while (!stack_.empty()) {
    const Choice& choice = chosen(stack_.back());
    stack_.pop_back();
    for (std::uint32_t i = 0; i < choice.operand_count; ++i) {
      const std::uint32_t operand = choice.operands[i];
      if (operand == node) return true;
      if (visited_[operand] == visit_) continue;
      visited_[operand] = visit_;
      stack_.push_back(operand);
    }
  }
  return false;
}

}  // namespace qvgen::passes::search_detail
