// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "passes/search/anneal.h"
#include "passes/search/operand_order.h"
#include "passes/search/random.h"
#include "passes/search/selection_state.h"

namespace qvgen::passes::search_detail {
namespace {

constexpr std::int32_t unit = Network::unit;

Choice choice(std::int32_t cost, std::initializer_list<std::uint32_t> operands, std::int32_t angle = -1) {
  Choice result;
  result.cost = cost * unit;
  result.angle = angle;
  for (const std::uint32_t operand : operands) result.operands[result.operand_count++] = operand;
  return result;
}

/// Random network: node i may be made from any two others, or from nodes below it.
Network random_network(std::uint64_t seed, std::uint32_t nodes) {
  Random random(seed);
  Network network;
  network.angle_costs = {5 * unit, 7 * unit};
  for (std::uint32_t i = 0; i < nodes; ++i) {
    network.first.push_back(static_cast<std::uint32_t>(network.choices.size()));
    network.choices.push_back(i < 4 ? choice(0, {},
                                             i < 2    ? 0
                                             : i == 2 ? 1
                                                      : -1)
                                    : choice(1, {random.below(i), random.below(i)}));
    if (i < 4) continue;
    for (std::uint32_t k = random.below(4); k > 0; --k) {
      const std::uint32_t a = random.below(nodes);
      const std::uint32_t b = random.below(nodes);
      if (a != i && b != i && a != b)
        network.choices.push_back(choice(1 + static_cast<std::int32_t>(random.below(2)), {a, b}));
    }
  }
  network.first.push_back(static_cast<std::uint32_t>(network.choices.size()));
  network.outputs = {nodes - 1, nodes - 2, nodes / 2};
  return network;
}

/// By taking away, again and again, all classes whose operands are gone.
bool is_acyclic(const std::vector<const Choice*>& choices) {
  std::vector<bool> gone(choices.size());
  const auto is_ready = [&](const Choice* choice) {
    bool ready = true;
    for (std::uint32_t i = 0; choice != nullptr && i < choice->operand_count; ++i)
      ready = ready && gone[choice->operands[i]];
    return ready;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t node = 0; node < choices.size(); ++node)
      if (!gone[node] && is_ready(choices[node])) gone[node] = changed = true;
  }
  return std::find(gone.begin(), gone.end(), false) == gone.end();
}

bool is_acyclic(const Network& network, const Selection& selection) {
  return is_acyclic(SelectionState(network, selection).choices());
}

TEST(SelectionState, CostFollowsEverySwitchAndItsUndoing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Network network = random_network(seed, 40);
    SelectionState state(network, Selection(network.size(), 0));
    const std::int64_t start = state.cost();
    Random random(seed);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> history;
    for (int i = 0; i < 100; ++i) {
      const std::uint32_t node = random.below(network.size());
      history.emplace_back(node, state.selection()[node]);
      state.select(node, random.below(network.choice_count(node)));
      if (!is_acyclic(state.choices())) {
        state.select(node, history.back().second);
        history.pop_back();
      }
      ASSERT_EQ(state.cost(), SelectionState(network, state.selection()).cost());
    }
    for (; !history.empty(); history.pop_back()) state.select(history.back().first, history.back().second);
    EXPECT_EQ(state.cost(), start);
  }
}

/// Also of choices that are refused, and of classes that have lost theirs.
TEST(OperandOrder, RefusesExactlyTheChoicesThatCloseACycle) {
  int refused = 0, taken = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Network network = random_network(seed, 40);
    std::vector<const Choice*> choices = SelectionState(network, Selection(network.size(), 0)).choices();
    OperandOrder order(choices);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
      const std::uint32_t node = random.below(network.size());
      const Choice& next = network.choices[network.first[node] + random.below(network.choice_count(node))];
      if (random.chance(64)) {
        order.clear(node);
        choices[node] = nullptr;
      }
      const Choice* before = std::exchange(choices[node], &next);
      const bool expected = is_acyclic(choices);
      if (!expected) choices[node] = before;
      ASSERT_EQ(order.assign(node, next), expected) << "seed " << seed << ", change " << i;
      (expected ? taken : refused)++;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 1000);
}

/// So often at one place that no label is left between two others.
TEST(OperandOrder, FindsRoomForEver) {
  Network network;
  network.choices = {choice(0, {}), choice(1, {0}), choice(1, {1})};
  OperandOrder order({nullptr, nullptr, nullptr});
  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(order.assign(2, network.choices[2]));
    EXPECT_TRUE(order.assign(1, network.choices[1]));
    EXPECT_FALSE(order.assign(0, network.choices[2]));
    order.clear(1);
    order.clear(2);
    EXPECT_TRUE(order.assign(0, network.choices[2]));
    order.clear(0);
  }
}

TEST(Anneal, NeverRisesNeverCyclesAndRepeatsItself) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Network network = random_network(seed, 60);
    const Selection start(network.size(), 0);
    const Selection found = anneal(network, start, {seed, 20'000});
    EXPECT_LE(cost_of(network, found), cost_of(network, start));
    EXPECT_TRUE(is_acyclic(network, found));
    EXPECT_EQ(found, anneal(network, start, {seed, 20'000}));
  }
}

TEST(Anneal, PaysAnAngleOnceAndAvoidsADearOne) {
  // 0, 1: sine and cosine of angle A; 2: another leaf for the same value as 3 = 0 * 1, but of the dear angle
  // B.
  Network network;
  network.angle_costs = {10 * unit, 30 * unit};
  network.first = {0, 1, 2, 4, 5};
  network.choices = {choice(0, {}, 0), choice(0, {}, 0), choice(0, {}, 1), choice(1, {0, 1}),
                     choice(1, {2, 0})};
  network.outputs = {3};
  const Selection found = anneal(network, Selection(4, 0), {1, 1000});
  EXPECT_EQ(cost_of(network, found), 12 * unit);
}

}  // namespace
}  // namespace qvgen::passes::search_detail
