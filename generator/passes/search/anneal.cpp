// SPDX-License-Identifier: MIT
#include "passes/search/anneal.h"

#include <array>
#include <optional>

#include "passes/search/operand_order.h"
#include "passes/search/random.h"
#include "passes/search/selection_state.h"

namespace qvgen::passes::search_detail {
namespace {

/// Temperature falls by a constant factor from block to block, in integers.
class Cooling {
 public:
  explicit Cooling(const Schedule& schedule) : schedule_(schedule) {
    const std::int64_t hot = static_cast<std::int64_t>(schedule.hot) << 16U;
    const std::int64_t cold = static_cast<std::int64_t>(schedule.cold) << 16U;
    for (factor_ = one; power(factor_, hot) > cold; factor_ -= one / 4096) {
    }
    temperature_ = hot;
  }
  /// Temperature at a step, in prices.
  std::int64_t at(std::int64_t step) {
    const std::int64_t block = step * blocks / schedule_.iterations;
    for (; block_ < block; ++block_) temperature_ = temperature_ * factor_ / one;
    return temperature_ >> 16U;
  }

 private:
  static constexpr std::int64_t blocks = 256, one = std::int64_t{1} << 20U;
  static std::int64_t power(std::int64_t factor, std::int64_t value) {
    for (std::int64_t i = 0; i < blocks; ++i) value = value * factor / one;
    return value;
  }
  Schedule schedule_;
  std::int64_t factor_ = one, temperature_ = 0, block_ = 0;
};

/// A step: up to four switches of one class each, tried and taken back together.
class Step {
 public:
  Step(const Network& network, SelectionState& state, Random& random)
      : network_(network), state_(state), order_(state.choices()), random_(random) {}

  void propose() {
    const std::uint32_t wanted = 1U + (random_.chance(102) ? 1U : 0U) + (random_.chance(51) ? 1U : 0U) +
                                 (random_.chance(26) ? 1U : 0U);
    count_ = 0;
    for (std::uint32_t i = 0; i < wanted && !state_.candidates().empty(); ++i) change(pick());
  }
  /// Goes on from the switched classes unless they close a cycle.
  bool accept() {
    if (order()) return true;
    undo();
    // The choices before are without a cycle.
    static_cast<void>(order());
    return false;
  }
  void undo() {
    for (std::uint32_t i = count_; i-- > 0;) state_.select(changes_[i].node, changes_[i].before);
  }

 private:
  struct Change {
    std::uint32_t node, before;
  };

  /// Mostly an operand of the class just switched, since what it needs has often never been looked at.
  std::uint32_t pick() {
    const auto& candidates = state_.candidates();
    const std::uint32_t any = candidates[random_.below(static_cast<std::uint32_t>(candidates.size()))];
    if (count_ == 0 || random_.chance(77)) return any;
    const Choice& parent = state_.chosen(changes_[count_ - 1].node);
    if (parent.operand_count == 0) return any;
    const std::uint32_t operand = parent.operands[random_.below(parent.operand_count)];
    return network_.choice_count(operand) > 1 ? operand : any;
  }
  void change(std::uint32_t node) {
    const std::uint32_t before = state_.selection()[node];
    const std::uint32_t count = network_.choice_count(node);
    changes_[count_++] = {node, before};
    state_.select(node, (before + 1 + random_.below(count - 1)) % count);
  }

  /// The switched classes among their operands and users; all lose their operands first, since one may break
  /// the cycle that another closes.
  bool order() {
    for (std::uint32_t i = 0; i < count_; ++i) order_.clear(changes_[i].node);
    for (std::uint32_t i = 0; i < count_; ++i)
      if (!order_.assign(changes_[i].node, state_.chosen(changes_[i].node))) return false;
    return true;
  }

  const Network& network_;
  SelectionState& state_;
  OperandOrder order_;
  Random& random_;
  std::array<Change, 4> changes_{};
  std::uint32_t count_ = 0;
};

}  // namespace

std::int64_t cost_of(const Network& network, const Selection& selection) {
  return SelectionState(network, selection).cost();
}

std::int64_t sufficient_steps(const Network& network, const Selection& selection) {
  constexpr std::int64_t for_any = 50'000, for_each = 300;
  return for_any +
         for_each * static_cast<std::int64_t>(SelectionState(network, selection).candidates().size());
}

Selection anneal(const Network& network, const Selection& start, const Schedule& schedule) {
  SelectionState state(network, start);
  Random random(schedule.seed);
  Cooling cooling(schedule);
  Step step(network, state, random);
  Selection best = start;
  std::int64_t best_cost = state.cost();
  for (std::int64_t i = 0; i < schedule.iterations; ++i) {
    const std::int64_t before = state.cost();
    const std::int64_t allowed = (cooling.at(i) * random.exponential()) >> 16U;
    step.propose();
    if (state.cost() - before > allowed) {
      step.undo();
    } else if (step.accept() && state.cost() < best_cost) {
      best_cost = state.cost();
      best = state.selection();
    }
  }
  return best;
}

}  // namespace qvgen::passes::search_detail
