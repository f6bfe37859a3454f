// SPDX-License-Identifier: MIT
// Gears among loops: a joint that follows others is one more equation, whose values sum up to a constant.
// It tells one joint's value by all others'. Given values tell it before all steps, whatever the factors.
// Steps find angles without whole turns; behind them it tells a value if the factors are whole.
// A polynomial tells the value of the joint that follows, and not that of the one that leads. Its value is
// that of the leader as it is, so behind steps it is taken only for joints that no other equation has.
#pragma once

#include <vector>

#include "derive/loops/cycle.h"

namespace qvgen::derive::loops {

/// A joint whose value is `constant` times the gear's offset and others' values, each times its factor.
struct Geared {
  std::size_t joint;
  std::vector<std::pair<std::size_t, cln::cl_RA>> sum;
  cln::cl_RA constant = 1;
  std::size_t cycle = 0;  ///< index of the gear among the cycles
};

/// Returns the sum of a gear's powers at a leader's value.
GiNaC::ex powers_at(const Cycle& gear, const GiNaC::ex& leader);

/// True if a joint leads by a polynomial, which does not tell its value.
bool leads_by_powers(const Cycle& gear, std::size_t joint);

/// Returns the gear `cycles[index]` as the value of one of its joints.
Geared solved_for(const std::vector<Cycle>& cycles, std::size_t index, std::size_t joint);

/// Returns joints that given ones lead, or are led by, one after the other.
std::vector<Geared> geared_by(const std::vector<Cycle>& cycles, const std::vector<std::size_t>& given);

/// Returns the value of such a joint as the one output of a program in the variables of the joints.
symbolic::Program program_of(const Geared& geared, const model::Robot& robot,
                             const std::vector<Cycle>& cycles);

}  // namespace qvgen::derive::loops
