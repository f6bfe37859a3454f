// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "derive/inverse/problem.h"

/// Arms with neighbouring joints in another order.
///
/// A turn and a slide along the direction of its axis commute, wherever the axis is. So a forearm that rolls
/// and then extends is the same arm as one that extends and then rolls: in the second order the roll is an
/// axis of the wrist, and the arm is a Stanford arm.
namespace qvgen::derive::inverse {

/// Returns the problem with its joints in every other order that such exchanges lead to, fewest exchanges
/// first. Rows stay as they are: `places` follows the joints. None if a joint is held.
std::vector<Problem> in_other_orders(const Problem& problem);

}  // namespace qvgen::derive::inverse
