// SPDX-License-Identifier: MIT
// Extra work near singular poses, counted: passes over the branches and evaluations of the Jacobian are
// refused beyond what is allowed. So no pose can take longer, and a set that wanted more says so. C has this
// header, too.
#pragma once

namespace qvgen::inverse {

/// Work beyond closed forms at a pose near a singular one. All zero elsewhere, except the evaluations that
/// polish the roots of a quartic.
struct Effort {
  int passes = 0;        ///< passes over the branches, one by one
  int steps = 0;         ///< evaluations of the Jacobian, a Newton step each or a test
  bool used_up = false;  ///< a pass or a step was refused while a branch was still undecided
};

/// How often each is allowed: counted, so that the bound holds by construction, whatever the pose.
struct Budget {
  int passes;
  int steps;
  bool persists = false;  ///< further choices are made as long as a branch is without a solution
  Effort spent = {};

  bool pass() {
    const bool allowed = spent.passes < passes;
    spent.passes += allowed ? 1 : 0;
    spent.used_up = spent.used_up || !allowed;
    return allowed;
  }
  bool step() {
    const bool allowed = spent.steps < steps;
    spent.steps += allowed ? 1 : 0;
    spent.used_up = spent.used_up || !allowed;
    return allowed;
  }
};

}  // namespace qvgen::inverse
