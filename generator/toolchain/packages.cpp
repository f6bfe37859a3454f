// SPDX-License-Identifier: MIT
#include "toolchain/packages.h"

#include <fstream>
#include <iterator>
#include <sstream>

namespace qvgen::toolchain {
namespace {

namespace fs = std::filesystem;

// Workspaces have packages at most so deep; whoever names the root of a disk waits no longer than a moment.
constexpr int deepest = 5;
constexpr std::size_t most_folders = 20'000;

/// Returns the name that a package.xml gives, empty if the folder has none.
std::string name_in(const fs::path& folder) {
  std::ifstream file(folder / "package.xml");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t begin = text.find("<name>"), end = text.find("</name>");
  if (begin == std::string::npos || end == std::string::npos || end < begin) return "";
  std::istringstream words(text.substr(begin + 6, end - begin - 6));
  std::string name;
  words >> name;
  return name;
}

void add(Packages& packages, const fs::path& folder, bool by_its_own_name) {
  const std::string name = name_in(folder);
  if (!name.empty())
    packages.emplace(name, folder);
  else if (by_its_own_name)
    packages.emplace(folder.filename().string(), folder);
}

/// Adds the packages in a folder, at any depth those with a package.xml.
void search(Packages& packages, const fs::path& root) {
  std::error_code error;
  add(packages, root, true);
  std::size_t seen = 0;
  fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && at != end && seen < most_folders; at.increment(error)) {
    if (!at->is_directory(error)) continue;
    ++seen;
    add(packages, at->path(), at.depth() == 0);
    if (at.depth() + 1 >= deepest) at.disable_recursion_pending();
  }
}

/// Adds the folders around a file and those beside them, by their names: packages stand side by side.
void search_around(Packages& packages, const fs::path& file) {
  std::error_code error;
  fs::path folder = fs::absolute(file, error).parent_path();
  for (int height = 0; height < deepest && folder.has_relative_path(); ++height) {
    add(packages, folder, true);
    std::size_t seen = 0;
    for (fs::directory_iterator at(folder, error), end; !error && at != end && seen < most_folders;
         at.increment(error), ++seen)
      if (at->is_directory(error)) add(packages, at->path(), true);
    folder = folder.parent_path();
  }
}

}  // namespace

Packages packages_in(const std::vector<std::string>& folders, const fs::path& file) {
  Packages packages;
  for (const std::string& joined : folders) {
    std::istringstream list(joined);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) search(packages, fs::absolute(folder).lexically_normal());
  }
  search_around(packages, file);
  return packages;
}

fs::path without_package(const std::string& path, const Packages& packages) {
  static const std::string mark = "package://";
  if (path.compare(0, mark.size(), mark) != 0) return path;
  const std::size_t slash = std::min(path.find('/', mark.size()), path.size());
  const auto found = packages.find(path.substr(mark.size(), slash - mark.size()));
  if (found == packages.end()) return {};
  return found->second / fs::path(path.substr(slash)).relative_path();
}

}  // namespace qvgen::toolchain
