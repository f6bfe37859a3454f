// SPDX-License-Identifier: MIT
// Plans of closed loops. Some joints of a mechanism are given; the loops hold the others, and give way one
// after the other: a rod places one joint, a pin two whose axes are parallel, three rods the three slides of
// a platform. Each is an equation of inverse kinematics (derive/inverse/kinds) whose target is the rest of
// the mechanism, so steps, certificates and emission are those of arms.
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/plan.h"
#include "derive/loops/chains.h"
#include "derive/loops/cycle.h"
#include "derive/loops/gears.h"
#include "model/mechanism.h"

namespace qvgen::derive::loops {

/// The steps from given joints to all others that loops hold, or the reasons why there are none.
struct AssemblyPlan {
  bool found = false;
  model::Robot robot;                ///< with private names, as the plan has them
  std::vector<std::size_t> given;    ///< joints with values of the caller's, in his order
  std::vector<Geared> geared;        ///< joints that those lead by gears, one after the other
  std::vector<Geared> led;           ///< joints that gears lead behind steps, in their order
  std::vector<LoopChain> chains;     ///< loops in space, solved before all steps, one after the other
  std::vector<std::size_t> passive;  ///< all but the given ones, sorted
  inverse::Plan plan;
  std::vector<Cycle> cycles;           ///< all, in the order of the file
  std::vector<std::size_t> used;       ///< indices of the cycles that steps have solved, in their order
  std::vector<std::size_t> redundant;  ///< indices of those that hold nothing more
  std::vector<std::string> reasons;

  /// Joints that are given or that gears lead by those.
  [[nodiscard]] std::vector<std::size_t> told() const;
  /// Joints whose values are known before the first step: these, and those of chains.
  [[nodiscard]] std::vector<std::size_t> known() const;
  /// Joints that a loop in space holds.
  [[nodiscard]] std::vector<std::size_t> held_by(std::size_t cycle) const;
  [[nodiscard]] bool has_gears() const { return !geared.empty() || !led.empty(); }
};

/// Derives the assemblies for given joints: those that are driven, or those that say where a platform is.
AssemblyPlan assembly_plan(const model::Mechanism& mechanism, const std::vector<std::size_t>& given);

}  // namespace qvgen::derive::loops
