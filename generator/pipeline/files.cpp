// SPDX-License-Identifier: MIT
#include "pipeline/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <unistd.h>

namespace qvgen::pipeline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& action, const fs::path& path) {
  throw std::runtime_error("cannot " + action + " " + path.string() + ": " + std::strerror(errno));
}

bool holds(const fs::path& path, const std::string& content) {
  std::ifstream file(path, std::ios::binary);
  return file && std::string(std::istreambuf_iterator<char>(file), {}) == content;
}

void write_atomically(const fs::path& path, const std::string& content) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  const fs::path temporary = path.string() + ".new-" + std::to_string(::getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << content;
  file.close();
  if (!file) {
    const int reason = errno;
    fs::remove(temporary, error);
    errno = reason;
    fail("write", path);
  }
  fs::rename(temporary, path, error);
  if (!error) return;
  errno = error.value();
  std::error_code ignored;
  fs::remove(temporary, ignored);
  fail("replace", path);
}

}  // namespace

int write_files(const fs::path& folder, const std::vector<OutputFile>& files) {
  int changed = 0;
  for (const OutputFile& file : files) {
    const fs::path path = folder / file.path;
    if (holds(path, file.content)) continue;
    write_atomically(path, file.content);
    ++changed;
  }
  return changed;
}

}  // namespace qvgen::pipeline
