// SPDX-License-Identifier: MIT
#include "pipeline/manifest.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace qvgen::pipeline {
namespace {

using nlohmann::ordered_json;

constexpr const char* note =
    "Every file of this folder that qvgen owns. What is not listed is never changed or removed.";

/// A manifest may come from anywhere; what it lists may be removed.
std::string checked(const std::string& path) {
  const std::filesystem::path parts(path);
  const bool leaves = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part == ".."; });
  if (path.empty() || parts.is_absolute() || leaves)
    throw std::invalid_argument("the path '" + path + "' is not inside the folder");
  return path;
}

std::vector<std::string> checked_paths(const ordered_json& list) {
  std::vector<std::string> paths;
  for (const auto& path : list) paths.push_back(checked(path.get<std::string>()));
  return paths;
}

}  // namespace

std::string to_text(const Manifest& manifest) {
  ordered_json robots = ordered_json::object();
  for (const auto& [name, robot] : manifest.robots) {
    std::vector<std::string> files = robot.files;
    std::sort(files.begin(), files.end());
    robots[name] = {{"description", robot.description}, {"files", files}};
  }
  return ordered_json{{"qvgen", note}, {"robots", robots}, {"shared", manifest.shared}}.dump(1) + "\n";
}

Manifest manifest_from_text(const std::string& text) {
  try {
    const ordered_json json = ordered_json::parse(text);
    Manifest manifest;
    for (const auto& [name, robot] : json.at("robots").items())
      manifest.robots[name] = {robot.at("description"), checked_paths(robot.at("files"))};
    for (const std::string& path : checked_paths(json.at("shared"))) manifest.shared.insert(path);
    return manifest;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

std::set<std::string> owned_paths(const Manifest& manifest) {
  std::set<std::string> paths = manifest.shared;
  for (const auto& [name, robot] : manifest.robots) paths.insert(robot.files.begin(), robot.files.end());
  return paths;
}

}  // namespace qvgen::pipeline
