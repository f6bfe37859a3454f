// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/attempt.h"

namespace qvgen::derive::inverse {

/// Returns the joints of an arm that `by_level` serves whose turns add up to nothing.
Balance balance_of(const Attempt& attempt);

}  // namespace qvgen::derive::inverse
