// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/blocks/unit.h"

/// A robot's functions as kernels of OpenCL and CUDA, a configuration a thread, made of its C. Both languages
/// take the C as it is, but for constants at file scope and the marks of functions; the kernels around it are
/// printed from the typed tree:
///
///     KERNEL void ns_jacobian_batch(const COUNT n, GLOBAL const double* q, const ns_geometry g, GLOBAL
///     double* result)
namespace qvgen::emit::kernels {

enum class Device { opencl, cuda };

/// A device's language, and whether the text will be renamed to float (`emit/c/single_precision.h`).
struct Target {
  Device device;
  bool in_float;
};

/// Texts of the robot's C; those of inverse kinematics may be empty.
struct Sources {
  std::string header, source, inverse_header, inverse_source;
};

/// Text of the file. `unit` is the tree of the sources; `missing` are lines for its head.
std::string file(const Target& target, const blocks::Unit& unit, const Sources& c,
                 const std::vector<std::string>& missing);

}  // namespace qvgen::emit::kernels
