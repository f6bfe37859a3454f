// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace qvgen::pipeline {

/// Memory of this machine about a folder, so that robots that have not changed need not be generated again.
/// It may be deleted at any time: then everything is generated anew.
struct FolderState {
  struct Robot {
    std::string key;                           ///< of all that its files were made from
    std::map<std::string, std::string> files;  ///< path -> fingerprint of the content
  };
  std::map<std::string, Robot> robots;
};

/// The folder for all that is not output: it tells version control to look away.
std::filesystem::path work_folder(const std::filesystem::path& folder);

/// Nothing remembered if there is no state, or none that can be read.
FolderState read_state(const std::filesystem::path& folder);
void write_state(const std::filesystem::path& folder, const FolderState& state);

/// Sixteen hexadecimal digits of a text.
std::string fingerprint(const std::string& text);

/// Returns the place where a file is written before it is moved to its own.
std::filesystem::path temporary_in(const std::filesystem::path& folder);
/// Removes what killed runs have left; for the process that holds the folder.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace qvgen::pipeline
