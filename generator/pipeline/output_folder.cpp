// SPDX-License-Identifier: MIT
#include "pipeline/output_folder.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "pipeline/lines_of_json.h"
#include "pipeline/manifest.h"

namespace qvgen::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* known_prefix = "robots:";

Manifest read_manifest(const fs::path& folder) {
  const auto text = content_of(folder / manifest_name);
  if (!text) return {};
  try {
    return manifest_from_text(*text);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error((folder / manifest_name).string() +
                             " is not what qvgen writes: " + error.what());
  }
}

/// Robots that the run takes away: those it is told to, and those whose descriptions have other names now.
std::set<std::string> leaving(const Manifest& manifest, const FolderUpdate& update) {
  std::set<std::string> names = update.removed;
  for (const auto& robot : update.robots)
    for (const auto& [name, earlier] : manifest.robots)
      if (earlier.description == robot.description && name != robot.output.robot) names.insert(name);
  for (const auto& robot : update.robots) names.erase(robot.output.robot);
  return names;
}

/// Robots' files and what all share, in the order in which they are written.
std::vector<OutputFile> files_of(const FolderUpdate& update, const ordered_json& counts) {
  std::vector<OutputFile> files;
  for (const auto& robot : update.robots)
    files.insert(files.end(), robot.output.files.begin(), robot.output.files.end());
  files.insert(files.end(), update.shared.begin(), update.shared.end());
  files.push_back({update.entries, lines_of_json(counts)});
  return files;
}

Manifest updated(Manifest manifest, const FolderUpdate& update, const std::set<std::string>& gone) {
  for (const std::string& name : gone) manifest.robots.erase(name);
  for (const auto& robot : update.robots) {
    Manifest::Robot entry{robot.description, {}};
    for (const OutputFile& file : robot.output.files) entry.files.push_back(file.path);
    manifest.robots[robot.output.robot] = entry;
  }
  manifest.shared = {update.entries};
  for (const OutputFile& file : update.shared) manifest.shared.insert(file.path);
  return manifest;
}

ordered_json merged_counts(const ordered_json& earlier, const FolderUpdate& update,
                           const std::set<std::string>& gone) {
  std::map<std::string, ordered_json> entries;
  for (const auto& [robot, entry] : earlier.items()) entries[robot] = entry;
  for (const std::string& name : gone) entries.erase(name);
  for (const auto& robot : update.robots) entries[robot.output.robot] = robot.output.counts;
  ordered_json all = ordered_json::object();
  for (const auto& [robot, entry] : entries) all[robot] = entry;
  return all;
}

/// A file of the same content as ours may be taken for ours.
void refuse_what_is_in_the_way(const fs::path& folder, const std::vector<OutputFile>& files,
                               const std::set<std::string>& owned) {
  std::string list;
  for (const OutputFile& file : files) {
    if (owned.count(file.path) > 0 || !fs::exists(fs::symlink_status(folder / file.path))) continue;
    if (content_of(folder / file.path) != file.content) list += "\n  " + (folder / file.path).string();
  }
  if (!list.empty())
    throw std::runtime_error("these files are in the way, qvgen has not written them:" + list +
                             "\nmove them, or name another folder with --output; nothing is written");
}

/// A folder holds code or pages, not both: either would take the other's files for its own that are gone.
void refuse_other_kind(const fs::path& folder, const Manifest& manifest, const std::string& entries) {
  if (manifest.shared.empty() || manifest.shared.count(entries) > 0) return;
  throw std::runtime_error(
      folder.string() +
      " holds what another command of qvgen has written; name another folder with --output");
}

/// Temporaries are made beside the output: renaming does not leave the file system.
void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot write " + folder.string() + ": " + error.message());
}

/// Removes a file, and the folders that it leaves empty.
void remove_file(const fs::path& folder, const std::string& path) {
  std::error_code error;
  fs::remove(folder / path, error);
  if (error) throw std::runtime_error("cannot remove " + (folder / path).string() + ": " + error.message());
  for (fs::path above = fs::path(path).parent_path(); !above.empty(); above = above.parent_path())
    if (!fs::remove(folder / above, error)) return;
}

class Writer {
 public:
  explicit Writer(fs::path folder) : folder_(std::move(folder)) {}

  void write(const std::string& path, const std::string& content) {
    if (fs::is_regular_file(folder_ / path) && content_of(folder_ / path) == content) return;
    make_folder((folder_ / path).parent_path());
    replace_file(folder_ / path, content, temporary_in(folder_));
    ++change_.written;
  }
  void remove(const std::string& path) {
    remove_file(folder_, path);
    ++change_.removed;
  }
  void write_manifest(const Manifest& manifest) {
    const std::string text = to_text(manifest);
    if (content_of(folder_ / manifest_name) != text)
      replace_file(folder_ / manifest_name, text, temporary_in(folder_));
  }
  [[nodiscard]] FolderChange change() const { return change_; }

 private:
  fs::path folder_;
  FolderChange change_;
};

/// Owns all that either does: while a run is at work, both its files and those that it will remove.
Manifest together(const Manifest& earlier, const Manifest& next) {
  Manifest both = next;
  for (const auto& [name, robot] : earlier.robots) {
    Manifest::Robot& entry = both.robots.emplace(name, Manifest::Robot{robot.description, {}}).first->second;
    std::set<std::string> files(entry.files.begin(), entry.files.end());
    files.insert(robot.files.begin(), robot.files.end());
    entry.files.assign(files.begin(), files.end());
  }
  both.shared.insert(earlier.shared.begin(), earlier.shared.end());
  return both;
}

FolderState remembered(FolderState state, const FolderUpdate& update) {
  for (const auto& robot : update.robots) {
    FolderState::Robot entry{robot.key, {}};
    for (const OutputFile& file : robot.output.files) entry.files[file.path] = fingerprint(file.content);
    state.robots[robot.output.robot] = entry;
  }
  return state;
}

FolderState without(FolderState state, const FolderUpdate& update, const std::set<std::string>& gone) {
  for (const std::string& name : gone) state.robots.erase(name);
  for (const auto& robot : update.robots) state.robots.erase(robot.output.robot);
  return state;
}

bool is_in_place(const fs::path& folder, const FolderState::Robot& robot) {
  return std::all_of(robot.files.begin(), robot.files.end(), [&](const auto& file) {
    const auto content = content_of(folder / file.first);
    return content && fingerprint(*content) == file.second;
  });
}

}  // namespace

std::string origin_of(const fs::path& description, const fs::path& folder, const fs::path& known_robots) {
  const fs::path file = fs::weakly_canonical(description);
  if (file.parent_path() == fs::weakly_canonical(known_robots))
    return known_prefix + file.filename().generic_string();
  return file.lexically_relative(fs::weakly_canonical(fs::absolute(folder))).generic_string();
}

bool is_known_origin(const std::string& origin) { return origin.rfind(known_prefix, 0) == 0; }

std::set<std::string> current_robots(const fs::path& folder,
                                     const std::vector<std::pair<std::string, std::string>>& names_and_keys,
                                     const std::string& entries) {
  std::set<std::string> current;
  const FolderState state = read_state(folder);
  if (state.robots.empty()) return current;
  const Manifest manifest = read_manifest(folder);
  const ordered_json counts = counts_in(folder, entries);
  for (const auto& [name, key] : names_and_keys) {
    const auto place = state.robots.find(name);
    if (place == state.robots.end() || place->second.key != key) continue;
    if (manifest.robots.count(name) > 0 && counts.contains(name) && is_in_place(folder, place->second))
      current.insert(name);
  }
  return current;
}

std::set<std::string> known_robots_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& [name, robot] : read_manifest(folder).robots)
    if (is_known_origin(robot.description)) names.insert(name);
  return names;
}

std::vector<std::string> files_of_robots(const fs::path& folder, const std::vector<std::string>& robots) {
  const Manifest manifest = read_manifest(folder);
  std::vector<std::string> files;
  for (const std::string& robot : robots)
    if (const auto place = manifest.robots.find(robot); place != manifest.robots.end())
      files.insert(files.end(), place->second.files.begin(), place->second.files.end());
  std::sort(files.begin(), files.end());
  return files;
}

std::set<std::string> robots_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& [name, robot] : read_manifest(folder).robots) names.insert(name);
  return names;
}

void check_folder(const fs::path& folder, const std::vector<OutputFile>& shared, const std::string& entries) {
  const Manifest manifest = read_manifest(folder);
  refuse_other_kind(folder, manifest, entries);
  const std::set<std::string> owned = owned_paths(manifest);
  refuse_what_is_in_the_way(folder, shared, owned);
  if (owned.count(entries) > 0) counts_in(folder, entries);
}

FolderChange update_folder(const fs::path& folder, const FolderUpdate& update) {
  make_folder(folder);
  const FolderLock lock(folder);
  const Manifest earlier = read_manifest(folder);
  refuse_other_kind(folder, earlier, update.entries);
  const std::set<std::string> gone = leaving(earlier, update);
  const std::set<std::string> owned = owned_paths(earlier);
  const std::vector<OutputFile> files = files_of(update, entries_after(folder, update));
  refuse_what_is_in_the_way(folder, files, owned);

  make_folder(work_folder(folder));
  remove_leftovers(folder);
  const Manifest next = updated(earlier, update, gone);
  FolderState state = without(read_state(folder), update, gone);
  write_state(folder, state);  // a run that is interrupted from here on leaves nothing that counts as current
  Writer writer(folder);
  writer.write_manifest(together(earlier, next));
  for (const OutputFile& file : files) writer.write(file.path, file.content);
  const std::set<std::string> kept = owned_paths(next);
  for (const std::string& path : owned)
    if (kept.count(path) == 0) writer.remove(path);
  writer.write_manifest(next);
  write_state(folder, remembered(state, update));
  return writer.change();
}

ordered_json entries_after(const fs::path& folder, const FolderUpdate& update) {
  const Manifest earlier = read_manifest(folder);
  const bool has_entries = owned_paths(earlier).count(update.entries) > 0;
  return merged_counts(has_entries ? counts_in(folder, update.entries) : ordered_json::object(), update,
                       leaving(earlier, update));
}

ordered_json counts_in(const fs::path& folder, const std::string& name) {
  const fs::path path = folder / name;
  return fs::exists(path) ? counts_of(path) : ordered_json::object();
}

ordered_json counts_of(const fs::path& path) {
  const auto text = content_of(path);
  if (!text) throw std::runtime_error(path.string() + " cannot be read");
  try {
    ordered_json counts = ordered_json::parse(*text);
    if (counts.is_object()) return counts;
  } catch (const nlohmann::json::exception&) {
    // said below
  }
  throw std::runtime_error(path.string() +
                           " holds no operation counts (cut short, or not written by qvgen): delete it and "
                           "generate again");
}

}  // namespace qvgen::pipeline
