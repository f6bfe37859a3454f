// SPDX-License-Identifier: MIT
#include "passes/search/operand_order.h"

#include <utility>

namespace qvgen::passes::search_detail {

OperandOrder::OperandOrder(std::vector<const Choice*> choices)
    : choices_(std::move(choices)),
      places_(choices_.size() + 1),
      head_(static_cast<std::uint32_t>(choices_.size())) {
  places_[head_].before = places_[head_].after = head_;
  ++visit_;
  for (std::uint32_t node = 0; node < head_; ++node) visit(node, head_, 0);
  for (const std::uint32_t node : late_) append(node, places_[head_].before);
  relabel();
}

void OperandOrder::append(std::uint32_t node, std::uint32_t after) {
  const std::uint32_t next = places_[after].after;
  places_[node].before = after;
  places_[node].after = next;
  places_[after].after = node;
  places_[next].before = node;
}

void OperandOrder::remove(std::uint32_t node) {
  const Place& place = places_[node];
  places_[place.before].after = place.after;
  places_[place.after].before = place.before;
}

void OperandOrder::relabel() {
  std::int64_t label = 0;
  for (std::uint32_t node = places_[head_].after; node != head_; node = places_[node].after)
    places_[node].label = label += gap;
}

bool OperandOrder::assign(std::uint32_t node, const Choice& choice) {
  if (!collect(node, choice)) return false;
  if (!late_.empty()) move_before(node);
  choices_[node] = &choice;
  return true;
}

bool OperandOrder::collect(std::uint32_t node, const Choice& choice) {
  late_.clear();
  ++visit_;
  for (std::uint32_t i = 0; i < choice.operand_count; ++i) {
    const std::uint32_t operand = choice.operands[i];
    if (operand == node || !visit(operand, node, places_[node].label)) return false;
  }
  return true;
}

/// Depth first, operands before users, through classes behind the label alone: no class before it needs
/// `node`.
bool OperandOrder::visit(std::uint32_t from, std::uint32_t node, std::int64_t label) {
  const auto enter = [&](std::uint32_t next) {
    if (places_[next].label < label || places_[next].visited == visit_) return;
    places_[next].visited = visit_;
    stack_.push_back({next, 0});
  };
  stack_.clear();
  enter(from);
  while (!stack_.empty()) {
    Frame& top = stack_.back();
    const Choice* choice = choices_[top.node];
    if (choice == nullptr || top.next == choice->operand_count) {
      late_.push_back(top.node);
      stack_.pop_back();
      continue;
    }
    const std::uint32_t operand = choice->operands[top.next++];
    if (operand == node) return false;
    enter(operand);
  }
  return true;
}

void OperandOrder::move_before(std::uint32_t node) {
  for (const std::uint32_t late : late_) remove(late);
  const std::uint32_t previous = places_[node].before;
  const std::int64_t low = places_[previous].label;
  const auto count = static_cast<std::int64_t>(late_.size());
  const std::int64_t step = (places_[node].label - low) / (count + 1);
  std::uint32_t last = previous;
  std::int64_t label = low;
  for (const std::uint32_t late : late_) {
    append(late, last);
    places_[late].label = label += step;
    last = late;
  }
  if (step == 0) relabel();
}

}  // namespace qvgen::passes::search_detail
