// SPDX-License-Identifier: MIT
#include "pipeline/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace qvgen::pipeline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& action, const fs::path& path, int reason) {
  throw std::runtime_error("cannot " + action + " " + path.string() + ": " + std::strerror(reason));
}

void write_all(int file, const std::string& content, const fs::path& path) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write", path, errno);
    done += static_cast<std::size_t>(written);
  }
}

}  // namespace

std::optional<std::string> content_of(const fs::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    fail("read", path, errno);
  }
  if (fs::is_directory(path)) fail("read", path, EISDIR);
  std::ostringstream content;
  content << file.rdbuf();
  return std::move(content).str();
}

void replace_file(const fs::path& path, const std::string& content, const fs::path& temporary) {
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("write", path, errno);
  try {
    write_all(file, content, path);
    // A full disk may tell only here.
    if (::close(file) != 0) fail("write", path, errno);
    if (::rename(temporary.c_str(), path.c_str()) != 0) fail("replace", path, errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

FolderLock::FolderLock(const fs::path& folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (file_ < 0) fail("open", folder, errno);
  while (::flock(file_, LOCK_EX) != 0) {
    if (errno == EINTR) continue;
    const int reason = errno;
    ::close(file_);
    fail("lock", folder, reason);
  }
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace qvgen::pipeline
