// SPDX-License-Identifier: MIT
#include "description/xml/file_text.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace qvgen::description::xml {

namespace fs = std::filesystem;

FileText read_text_of(const fs::path& path, std::size_t largest) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return {"", "it is a directory", false};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return {"", std::strerror(errno == 0 ? EIO : errno), false};
  FileText result;
  char part[65536];
  while (file.read(part, sizeof part), file.gcount() > 0) {
    result.text.append(part, static_cast<std::size_t>(file.gcount()));
    if (result.text.size() > largest)
      return {"", "it has more than " + std::to_string(largest / 1'000'000) + " MB", true};
  }
  return result;
}

fs::path plain_path(const fs::path& path) {
  std::error_code error;
  fs::path plain = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : plain;
}

}  // namespace qvgen::description::xml
