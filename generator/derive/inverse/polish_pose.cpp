// SPDX-License-Identifier: MIT
#include "derive/inverse/attempt.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using symbolic::Vector;

void polish_pose(Attempt& attempt, const Target& target) {
  const GiNaC::ex size = GiNaC::sqrt(symbolic::symbol(names::size_square));
  std::vector<Vector> start;
  std::vector<Vector> goal;
  for (const Vector& away : {Vector{0, 0, 0}, Vector{1, 0, 0}, Vector{0, 1, 0}}) {
    start.push_back(attempt.chain.home.p + size * away);
    goal.push_back(target.image(start.back()));
  }
  attempt.builder.polish(attempt.chain.screws, start, goal);
}

}  // namespace qvgen::derive::inverse
