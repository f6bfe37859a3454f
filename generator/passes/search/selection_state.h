// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "passes/search/anneal.h"

namespace qvgen::passes::search_detail {

/// A selection with the reference counts of the classes it uses, and their cost.
class SelectionState {
 public:
  SelectionState(const Network& network, Selection selection);

  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] const Selection& selection() const { return selection_; }
  /// Classes in use that have more than one choice.
  [[nodiscard]] const std::vector<std::uint32_t>& candidates() const { return candidates_; }
  [[nodiscard]] const Choice& chosen(std::uint32_t node) const { return *uses_[node].chosen; }
  void select(std::uint32_t node, std::uint32_t choice);
  /// Returns the choice of each class, null for classes without.
  [[nodiscard]] std::vector<const Choice*> choices() const;

 private:
  /// Kept together, since a switch of one class visits many.
  struct Use {
    const Choice* chosen = nullptr;
    std::uint32_t references = 0;
    std::uint32_t place = 0;  ///< among the candidates
    bool has_alternatives = false;
  };

  void acquire(std::uint32_t node);
  void release(std::uint32_t node);
  void acquire_operands(const Choice& choice);
  void release_operands(const Choice& choice);

  const Network& network_;
  Selection selection_;
  std::vector<Use> uses_;
  std::vector<std::uint32_t> angle_references_;
  std::vector<std::uint32_t> candidates_;
  std::int64_t cost_ = 0;
};

}  // namespace qvgen::passes::search_detail
