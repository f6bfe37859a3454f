// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace qvgen::toolchain {

/// How a program has ended: whether well, and all that it printed; or why it did not start.
struct Outcome {
  bool done = false;
  std::string said;
};

/// Runs a program in a folder and waits for its end. The first word is its name or path. May be called by
/// several threads at a time.
Outcome run(const std::vector<std::string>& words, const std::filesystem::path& folder = ".");

/// Whether the machine has a program of that name or path.
bool is_program(const std::string& name);

}  // namespace qvgen::toolchain
