// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "passes/search/network.h"

namespace qvgen::passes::search_detail {

/// An order of all classes in which the operands of every class stand before it, kept up while classes change
/// their choices: whether a change closes a cycle is known from the few classes out of order.
///
/// Classes are a linked list with labels that grow along it; those that must move get labels between two
/// others (order maintenance, Dietz and Sleator 1987, in its simplest form).
class OperandOrder {
 public:
  /// `choices`: of each class the one it takes, null for classes without; together without a cycle.
  explicit OperandOrder(std::vector<const Choice*> choices);

  /// Takes the class' choice away: it has no operands until it is given the next.
  void clear(std::uint32_t node) { choices_[node] = nullptr; }
  /// Gives the class a choice; false, and nothing changed, if an operand needs the class itself.
  [[nodiscard]] bool assign(std::uint32_t node, const Choice& choice);

 private:
  bool collect(std::uint32_t node, const Choice& choice);
  bool visit(std::uint32_t from, std::uint32_t node, std::int64_t label);
  void move_before(std::uint32_t node);
  void append(std::uint32_t node, std::uint32_t after);
  void remove(std::uint32_t node);
  void relabel();

  static constexpr std::int64_t gap = std::int64_t{1} << 32U;

  struct Frame {
    std::uint32_t node, next;  ///< operands before `next` are done
  };
  struct Place {
    std::int64_t label = 0;
    std::uint32_t before = 0, after = 0;
    std::uint32_t visited = 0;
  };

  std::vector<const Choice*> choices_;
  std::vector<Place> places_;  ///< the last one, head_, stands before the first and after the last class
  std::uint32_t head_;
  std::vector<std::uint32_t>
      late_;  ///< classes that an operand needs and that stand too late, operands first
  std::vector<Frame> stack_;
  std::uint32_t visit_ = 0;
};

}  // namespace qvgen::passes::search_detail
