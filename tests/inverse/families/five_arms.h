// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "built_arms.h"

namespace qvgen::test {

/// Arms with five joints as they are built, without names and titles.
inline constexpr std::array<const char*, 1> five_arms{
    // Three parallel axes behind a first one across them (link lengths of the youBot's arm). With the tool
    // point on the first axis that is free, and the links follow for few of its angles.
    youbot_arm};

}  // namespace qvgen::test
