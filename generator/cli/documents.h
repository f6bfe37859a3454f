// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace qvgen::cli {

/// Value of an option, or an argument without a name.
struct Value {
  enum class Kind { none, robot, file, folder, parts, choice, other };
  Kind kind = Kind::none;
  std::string name;                  ///< as help calls it, empty for a flag
  std::vector<std::string> choices;  ///< all that it may be
};
Value value_of(const CLI::Option& option);

std::vector<const CLI::App*> commands_of(const CLI::App& app);
/// Those with names, --help first; and those without.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<const CLI::Option*> arguments_of(const CLI::App& command);
/// "-o" and "--output"
std::vector<std::string> names_of(const CLI::Option& option);

/// The command line as a man page of section 1.
std::string man_page(const CLI::App& app);

/// A script that completes the command line in "bash", "zsh" or "fish".
std::string completion(const CLI::App& app, const std::string& shell);
std::string zsh_completion(const CLI::App& app);

}  // namespace qvgen::cli
