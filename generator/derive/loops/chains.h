// SPDX-License-Identifier: MIT
// Welds and slides in space as inverse kinematics. A loop is a ring of joints. Those that it holds are a
// chain, and the joints whose values are known lead from the chain's beginning to its end along the rest of
// the ring: so they tell the pose that the chain has to reach. A slide is one more joint of the chain. From
// motors and from outputs a loop is two chains each, unless it holds the same joints both ways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derive/loops/cycle.h"
#include "model/mechanism.h"

namespace qvgen::derive::loops {

/// A loop as two chains between the same frames, with the description's names.
struct LoopChain {
  std::size_t cycle = 0;  ///< index among the cycles
  model::Robot chain;     ///< of the joints that the loop holds
  model::Robot rest;      ///< of the others
  /// For each joint of the chain its index in the mechanism; nothing: how far the loop's slide is.
  std::vector<std::optional<std::size_t>> joints;
  std::vector<std::size_t> rest_joints;

  /// Joints of the mechanism that the loop holds.
  [[nodiscard]] std::vector<std::size_t> held() const;
};

/// Returns the loop that `cycle` is among a mechanism's as two chains if it is a weld or a slide in space
/// whose joints behind each other are known and unknown; else the reason, without "loop N".
struct ChainOrReason {
  std::optional<LoopChain> chain = {};
  std::string reason = {};
};
ChainOrReason chain_of(const model::Mechanism& mechanism, const Cycle& cycle,
                       const std::vector<std::size_t>& known);

/// Returns the loops that are solved so, one after the other, from given joints on: the driven ones or the
/// outputs. From others none is.
std::vector<LoopChain> chains_of(const model::Mechanism& mechanism, const std::vector<Cycle>& cycles,
                                 const std::vector<std::size_t>& given);
/// Returns those from the driven joints and those from the outputs, each chain once; nothing for a mechanism
/// whose loops cannot be read.
std::vector<LoopChain> chains_of(const model::Mechanism& mechanism);

}  // namespace qvgen::derive::loops
