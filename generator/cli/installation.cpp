// SPDX-License-Identifier: MIT
#include "cli/installation.h"

#include "exact/hash.h"
#include "pipeline/files.h"

namespace qvgen::cli {

namespace fs = std::filesystem;

Installation find_installation() {
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  const std::uint64_t tool = exact::hash(pipeline::content_of(executable).value_or(""));
  // The build writes this file beside the executable; an installed one has none.
  if (auto source = pipeline::content_of(executable.parent_path() / "qvgen_source_tree")) {
    source->erase(source->find_last_not_of('\n') + 1);
    const fs::path tree = *source;
    return {tree / "generator" / "robots", tree, tool};
  }
  return {executable.parent_path().parent_path() / "share" / "qvgen" / "robots", std::nullopt, tool};
}

}  // namespace qvgen::cli
