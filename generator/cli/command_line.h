// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/calibrate_command.h"
#include "cli/commands.h"
#include "cli/identify_command.h"
#include "cli/path_options.h"

namespace qvgen::cli {

/// The commands and options: the one table that parses a call and that help, man page and completion are
/// printed from. What an option takes is told by its type's name, FILE, FOLDER, ROBOT, PARTS, or by the
/// values in braces.
struct CommandLine {
  CLI::App app{"qvgen: symbolic code generator for robot manipulators", "qvgen"};
  std::string output;  ///< of every command that has it

  CLI::App* generate_command = nullptr;
  GenerateArguments generate;
  std::vector<std::string> generate_files;
  std::vector<std::string> languages = {"cxx"};
  std::string scalar = "double";

  CLI::App* remove_command = nullptr;
  std::vector<std::string> removed;

  CLI::App* show_command = nullptr;
  std::string shown;
  ShowArguments show;
  bool functions = false;

  CLI::App* counts_command = nullptr;
  CountsArguments counts;

  CLI::App* compare_command = nullptr;
  std::vector<std::string> compared, levels;
  std::string what = "forward";
  CompareArguments compare;

  CLI::App* report_command = nullptr;
  std::vector<std::string> reported;
  ReportArguments report;

  CLI::App* map_command = nullptr;
  std::string mapped;
  MapArguments map;

  CLI::App* calibrate_command = nullptr;
  CalibrateArguments calibrate;
  CLI::App* identify_command = nullptr;
  std::string identified;
  IdentifyArguments identify;
  CLI::App* path_command = nullptr;
  PathArguments path;

  CLI::App* check_command = nullptr;
  std::vector<std::string> checked;
  description::ReadOptions check;
  bool thorough = false;

  CLI::App* import_command = nullptr;
  std::string imported;
  description::ReadOptions import;

  CLI::App* new_command = nullptr;
  std::string letters, wrist = "none", name = "my_arm";

  CLI::App* list_command = nullptr;
  CLI::App* languages_command = nullptr;

  CLI::App* manual_command = nullptr;
  CLI::App* completion_command = nullptr;
  std::string shell;

  CommandLine();
  CommandLine(const CommandLine&) = delete;  // the options point into it
  CommandLine& operator=(const CommandLine&) = delete;
};

}  // namespace qvgen::cli
