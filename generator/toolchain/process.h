// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
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

/// Runs a program that reads a short text, and takes its output piece by piece as it comes; its stderr goes
/// where ours goes. The outcome says how it ended if not well. What `take` throws ends the program.
Outcome run(const std::vector<std::string>& words, const std::string& input,
            const std::function<void(std::string_view)>& take);

/// Returns where the machine has a program of that name or path; empty if it has none.
std::filesystem::path program_path(const std::string& name);
/// True if the machine has a program of that name or path.
bool is_program(const std::string& name);

}  // namespace qvgen::toolchain
