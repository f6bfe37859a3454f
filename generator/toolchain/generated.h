// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "toolchain/build.h"

namespace qvgen::toolchain {

/// Needs of generated code besides a compiler.
struct Runtime {
  std::vector<std::filesystem::path> headers;   ///< folders: the runtime's, Eigen's
  std::filesystem::path sources;                ///< of the runtime; empty where it is installed as libraries
  std::vector<std::filesystem::path> archives;  ///< in the linker's order; empty: the sources are compiled
};

/// Returns the runtime of a source tree, or of the prefix where the tool is installed. Eigen's folder is
/// $QVGEN_EIGEN, or that of Debian. Libraries of a build of the source tree are taken if all are in one
/// folder of $QVGEN_LIBRARIES. Throws std::runtime_error if anything is not there.
Runtime runtime_of(const std::filesystem::path& source_tree);
Runtime runtime_in(const std::filesystem::path& prefix);

/// Returns the options with which every source of generated code is compiled.
std::vector<std::string> options_of_all(const Runtime& runtime);

/// A generated source as runtime/cmake/qvgenRobot.cmake compiles it: inverse kinematics without contraction,
/// vector forms for AVX2.
Source generated_source(const std::filesystem::path& file);

/// The sources or the library of the runtime that generated sources need by what they include.
void add_runtime(const Runtime& runtime, const std::vector<std::filesystem::path>& generated,
                 Program& program);

}  // namespace qvgen::toolchain
