// SPDX-License-Identifier: MIT
#include "toolchain/workshop.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace qvgen::toolchain {

namespace fs = std::filesystem;

Workshop::Workshop(const fs::path& inside) {
  std::string name = (inside / "qvgen-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no folder can be made in " + inside.string());
  folder_ = name;
}

Workshop::~Workshop() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

void Workshop::write(const std::string& name, const std::string& content) const {
  const fs::path path = folder_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

std::string Workshop::read(const std::string& name) const {
  std::ifstream file(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace qvgen::toolchain
