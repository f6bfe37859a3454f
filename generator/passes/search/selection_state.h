// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "passes/search/anneal.h"

namespace qvgen::passes::search_detail {

/// A selection with the reference counts of the classes it uses, and their cost.
///
/// The graph of all selected choices, used or not, is kept acyclic by the caller: then switching one class
/// can close a cycle only through that class.
class SelectionState {
 public:
  SelectionState(const Network& network, Selection selection);

  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] const Selection& selection() const { return selection_; }
  /// Classes in use that have more than one choice.
  [[nodiscard]] const std::vector<std::uint32_t>& candidates() const { return candidates_; }
  [[nodiscard]] const Choice& chosen(std::uint32_t node) const {
    return network_.choices[network_.first[node] + selection_[node]];
  }
  void select(std::uint32_t node, std::uint32_t choice);
  /// Whether the class needs its own value.
  [[nodiscard]] bool on_cycle(std::uint32_t node);

 private:
  void acquire(std::uint32_t node);
  void release(std::uint32_t node);
  void acquire_operands(const Choice& choice);
  void release_operands(const Choice& choice);

  const Network& network_;
  Selection selection_;
  std::vector<std::uint32_t> references_, angle_references_;
  std::vector<std::uint32_t> candidates_, place_;
  std::vector<std::uint32_t> visited_, stack_;
  std::uint32_t visit_ = 0;
  std::int64_t cost_ = 0;
};

}  // namespace qvgen::passes::search_detail
