// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/report.h"
#include "description/reader.h"

namespace qvgen::cli {

/// Exit codes of the tool.
enum ExitCode { success = 0, failure = 1, usage_error = 2, bad_description = 3 };

struct GenerateArguments {
  std::vector<std::filesystem::path> descriptions;
  std::filesystem::path output;
  description::ReadOptions read;
  std::vector<std::string> parts;     ///< see pipeline.h
  std::vector<std::string> required;  ///< products without which a robot is an error
};

struct ShowArguments {
  std::filesystem::path description;
  description::ReadOptions read;
  bool latex = false;
  bool singularities = false;
  bool dynamics = false;  ///< the joint forces in place of the pose
  bool inverse = false;   ///< the derivation of inverse kinematics instead of the closed form of the pose
};

/// Each command prints its results to stdout and messages to stderr, and returns an ExitCode.
int run_generate(const GenerateArguments& arguments);
int run_show(const ShowArguments& arguments);
int run_counts(const std::filesystem::path& counts_file, ReportFormat format, bool forms);
int run_check(const std::vector<std::filesystem::path>& descriptions,
              const description::ReadOptions& options);
/// Prints a URDF or MJCF as TOML.
int run_import(const std::filesystem::path& description, const description::ReadOptions& options);
/// Prints a description to edit: a known robot's, or one of joints by their letters.
int run_new(const std::string& code, const std::string& name, bool euler_wrist,
            const std::filesystem::path& robots);

/// Every *.toml of a folder, sorted by name.
std::vector<std::filesystem::path> descriptions_in(const std::filesystem::path& folder);

}  // namespace qvgen::cli
