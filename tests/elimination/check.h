// SPDX-License-Identifier: MIT
// What the tests of arms share: how many poses they draw, and how a test of an arm is called.
#pragma once

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "arms.h"

namespace qvgen::test {

/// Poses to draw: as many as the environment variable QVGEN_POSES says, or else the usual number.
inline int pose_count(int usual) {
  const char* text = std::getenv("QVGEN_POSES");
  return text == nullptr ? usual : std::atoi(text);
}

/// The end of a test's name: the arm's name.
inline std::string name_of(const testing::TestParamInfo<Arm>& info) { return info.param.name; }

}  // namespace qvgen::test
