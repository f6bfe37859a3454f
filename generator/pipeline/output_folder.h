// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

inline constexpr const char* counts_name = "operation_counts.json";

/// Files that a run leaves in its folder.
struct FolderUpdate {
  struct Robot {
    RobotOutput output;
    std::string description;  ///< `origin_of` its description
    std::string key;          ///< of all that its files are made from; see `current_robots`
  };
  std::vector<Robot> robots;          ///< each replaces all that the folder has of it
  std::set<std::string> removed;      ///< robots that shall be gone
  std::vector<OutputFile> shared;     ///< beside `entries`
  std::string entries = counts_name;  ///< the file of the counts of all robots
};

struct FolderChange {
  int written = 0;
  int removed = 0;
};

/// Returns the path of a description, seen from the folder that its robot is written to, or the name of a
/// robot that the tool knows. It never says where folder and description lie on this machine.
std::string origin_of(const std::filesystem::path& description, const std::filesystem::path& folder,
                      const std::filesystem::path& known_robots);
bool is_known_origin(const std::string& origin);

/// The robots of a folder whose files are what the run with that key has left there.
std::set<std::string> current_robots(const std::filesystem::path& folder,
                                     const std::vector<std::pair<std::string, std::string>>& names_and_keys,
                                     const std::string& entries = counts_name);

/// The robots of a folder that came from known descriptions.
std::set<std::string> known_robots_in(const std::filesystem::path& folder);

/// Their files, relative to the folder.
std::vector<std::string> files_of_robots(const std::filesystem::path& folder,
                                         const std::vector<std::string>& robots);

/// All robots of a folder.
std::set<std::string> robots_in(const std::filesystem::path& folder);

/// Throws what `update_folder` would throw for the files of all robots, before these are generated.
void check_folder(const std::filesystem::path& folder, const std::vector<OutputFile>& shared,
                  const std::string& entries = counts_name);

/// Brings a folder up to date: files that have changed are replaced one by one as a whole, what is no longer
/// generated is removed, and so is a robot whose description has given another name now. One process at a
/// time. Throws std::runtime_error, before anything is changed, if a file is in the way that qvgen has not
/// written.
FolderChange update_folder(const std::filesystem::path& folder, const FolderUpdate& update);

/// The entries of all robots that a folder will have after the run.
nlohmann::ordered_json entries_after(const std::filesystem::path& folder, const FolderUpdate& update);

/// The content of a folder's operation_counts.json, or of the file of that name. Throws std::runtime_error
/// that names the file if it is none.
nlohmann::ordered_json counts_in(const std::filesystem::path& folder, const std::string& name = counts_name);
/// Reads the counts of a file, which must be there.
nlohmann::ordered_json counts_of(const std::filesystem::path& path);

}  // namespace qvgen::pipeline
