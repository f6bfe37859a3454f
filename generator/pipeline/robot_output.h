// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace qvgen::pipeline {

/// A file to write, path relative to the output folder.
struct OutputFile {
  std::string path;
  std::string content;
};

/// What one robot yields: its files and its entry in operation_counts.json.
struct RobotOutput {
  std::string robot;
  std::vector<OutputFile> files;
  nlohmann::ordered_json counts;
  std::vector<std::string> missing;  ///< products that this robot does not get, each with the reason
};

/// To and from text, for the way between processes.
std::string to_text(const RobotOutput& output);
RobotOutput robot_output_from_text(const std::string& text);

}  // namespace qvgen::pipeline
