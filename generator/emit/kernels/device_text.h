// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace qvgen::emit::kernels {

/// C without what devices do not have: lines of the preprocessor, public constants with their comments, and
/// what is for C++ alone. The robot's public functions get a mark in front. The sine and the cosine of an
/// angle, one line behind the other, become one call, which reduces the angle once.
std::string device_text(const std::string& robot, const std::string& c);

}  // namespace qvgen::emit::kernels
