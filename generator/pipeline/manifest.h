// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace qvgen::pipeline {

/// List of the files that qvgen owns in a folder: files that are not listed here are never changed or
/// removed. Paths are relative to the folder, with '/'.
struct Manifest {
  struct Robot {
    std::string description;  ///< where it comes from, see `origin_of`
    std::vector<std::string> files;
  };
  std::map<std::string, Robot> robots;
  std::set<std::string> shared;  ///< of all robots: counts, README
};

inline constexpr const char* manifest_name = "qvgen_manifest.json";

/// Writes a manifest; equal manifests give equal texts.
std::string to_text(const Manifest& manifest);
/// Throws std::invalid_argument if the text is no manifest, or names a path outside its folder.
Manifest manifest_from_text(const std::string& text);

/// Every path that it lists.
std::set<std::string> owned_paths(const Manifest& manifest);

}  // namespace qvgen::pipeline
