// SPDX-License-Identifier: MIT
#pragma once

#include "case.h"

namespace qvgen::test {

/// An arm that is written down here and solved as it is, nothing generated.
struct WrittenArm {
  InverseUnderTest functions;
  reference::Chain chain;
};

/// A column on a rail that carries an arm with an offset hand.
reference::Chain arm_on_a_rail();

/// All axes along coordinate axes, none parallel to the one before it; two joints slide. Of every second arm
/// half of the lengths are zero.
reference::Chain right_angled_arm(unsigned seed);

/// True if the solver takes the arm; one that is singular everywhere it does not.
bool is_solved(const reference::Chain& chain);
WrittenArm written_arm(const reference::Chain& chain);

}  // namespace qvgen::test
