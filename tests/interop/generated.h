// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "peers.h"

namespace arms {

/// Generated functions against KDL (format urdf) or MuJoCo (xml), which read the arm's file with all digits.
void compare_generated(Peer&& generated, const std::string& arm, const std::string& format);

}  // namespace arms
