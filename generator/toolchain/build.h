// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "toolchain/process.h"

namespace qvgen::toolchain {

/// A file to compile, and what is said of it alone.
struct Source {
  std::filesystem::path file;
  std::vector<std::string> options = {};
};

/// Sources and options of a program.
struct Program {
  std::vector<std::string> compiler;  ///< its words: a launcher, ccache, may stand before it
  std::vector<std::string> options;   ///< of every source
  std::vector<Source> sources;
  std::vector<std::string> libraries = {};  ///< the last words of the linker's command
  /// Folder in which the compiler runs: what it is told may be relative to it, so that ccache knows it again.
  std::filesystem::path folder = ".";
  /// Folder that keeps objects for other programs (kept_objects.h); empty: none is kept.
  std::filesystem::path kept = {};
};

/// Told the name of each file as it is done.
using Progress = std::function<void(const std::string& done)>;

/// The machine's C++ compiler: $CXX, or c++.
std::vector<std::string> cxx_compiler();

/// Returns what the machine lacks to run a compiler, as a part of a sentence; empty if nothing.
std::string missing(const std::vector<std::string>& compiler);

/// Compiles on all cores and links. The program appears whole or not at all, and what the compiler left on
/// the way is gone. If it fails the outcome has the command and what it printed, of the first source that
/// failed.
Outcome build(const Program& program, const std::filesystem::path& target, const Progress& progress = {});

}  // namespace qvgen::toolchain
