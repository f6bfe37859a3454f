// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "emit/blocks/unit.h"

/// All solutions of a pose on a device, a pose a thread. The robot's C solves a pose by its equations, and
/// says whether rounding decides what exists and whether a joint is free. Where that is so, its passes near
/// singular poses follow, which would keep a whole group of threads waiting: here such a pose is marked as
/// doubtful, for the CPU.
namespace qvgen::emit::kernels {

/// Functions and the kernel; empty for a robot that has no solutions of whole poses. `header` and `source`
/// are the texts of the robot's C for inverse kinematics.
std::string inverse_text(const blocks::Unit& unit, const std::string& header, const std::string& source);

}  // namespace qvgen::emit::kernels
