// SPDX-License-Identifier: MIT
#include "cli/installation.h"

#include <array>
#include <fstream>

#include "pipeline/files.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;

/// Hash of a file, eight bytes at a time: every run of the tool makes that of its executable.
std::uint64_t hash_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<std::uint64_t, 8192> words{};
  std::uint64_t hash = 0xcbf29ce484222325U;
  while (file) {
    words.fill(0);  // behind the end of the file
    file.read(reinterpret_cast<char*>(words.data()), sizeof words);
    for (const std::uint64_t word : words) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    }
  }
  return hash;
}

}  // namespace

Installation find_installation() {
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  const std::uint64_t tool = hash_of(executable);
  // The build writes this file beside the executable; an installed one has none.
  if (auto source = pipeline::content_of(executable.parent_path() / "qvgen_source_tree")) {
    source->erase(source->find_last_not_of('\n') + 1);
    const fs::path tree = *source;
    return {tree / "generator" / "robots", tree, tool};
  }
  return {executable.parent_path().parent_path() / "share" / "qvgen" / "robots", std::nullopt, tool};
}

}  // namespace qvgen::cli
