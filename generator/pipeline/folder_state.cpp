// SPDX-License-Identifier: MIT
#include "pipeline/folder_state.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "exact/hash.h"
#include "pipeline/files.h"

namespace qvgen::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

fs::path state_path(const fs::path& folder) { return work_folder(folder) / "state.json"; }

}  // namespace

fs::path work_folder(const fs::path& folder) { return folder / ".qvgen"; }

fs::path temporary_in(const fs::path& folder) { return work_folder(folder) / "new"; }

FolderState read_state(const fs::path& folder) {
  FolderState state;
  try {
    const auto json = ordered_json::parse(content_of(state_path(folder)).value_or(""));
    for (const auto& [name, robot] : json.at("robots").items())
      state.robots[name] = {robot.at("key"), robot.at("files")};
  } catch (const std::exception&) {
    return {};
  }
  return state;
}

void write_state(const fs::path& folder, const FolderState& state) {
  ordered_json robots = ordered_json::object();
  for (const auto& [name, robot] : state.robots) robots[name] = {{"key", robot.key}, {"files", robot.files}};
  if (!fs::exists(work_folder(folder) / ".gitignore"))
    replace_file(work_folder(folder) / ".gitignore", "*\n", temporary_in(folder));
  replace_file(state_path(folder), ordered_json{{"robots", robots}}.dump(1) + "\n", temporary_in(folder));
}

std::string fingerprint(const std::string& text) { return fmt::format("{:016x}", exact::hash(text)); }

void remove_leftovers(const fs::path& folder) {
  std::error_code none;
  fs::remove(temporary_in(folder), none);
}

}  // namespace qvgen::pipeline
