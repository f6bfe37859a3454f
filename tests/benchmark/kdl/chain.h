// SPDX-License-Identifier: MIT
#pragma once

#include <kdl/chain.hpp>

#include "reference/chain.h"

namespace comparison {

/// A chain in Orocos KDL with as few segments as it has joints, and KDL's cheapest joint types where they do.
KDL::Chain to_kdl(const reference::Chain& chain);

}  // namespace comparison
