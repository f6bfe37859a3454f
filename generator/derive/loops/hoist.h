// SPDX-License-Identifier: MIT
// Values of a plan where they are first known. The derivation of loops names a value when an equation needs
// it, behind the step before, so once for each sign of that step. A value that reads nothing of the step
// moves up: behind the last step it does read, or to the target, which is computed once for all assemblies.
// A value that a fork leaves for a later one may also read a fork in between, which the first has nothing to
// do with. It moves down to the one that reads it, so that the first two are solved once each.
#pragma once

#include "derive/inverse/plan.h"

namespace qvgen::derive::loops {

/// Moves named values up to where all that they read is known, or down to the fork that alone reads them.
void hoist(inverse::Plan& plan);

}  // namespace qvgen::derive::loops
