// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "map/about.h"

namespace qvgen::map {

/// Blocks of a map by their numbers.
using Blocks = std::map<int, std::vector<Cell>>;

/// A map, or a part of one.
struct Part {
  About about;
  Blocks blocks;
};

/// The blocks 0 ... Grid::blocks - 1 that are not there, as "3, 17:20"; empty if all are.
std::string missing_blocks(const Blocks& blocks);

/// A file of parts: a line of JSON, then blocks, each with its number and a check sum. Throws
/// std::runtime_error with the path if it cannot be read, is no such file or is cut short.
Part read_part(const std::filesystem::path& file);
std::string part_text(const Part& part);

/// Parts of one map as one. Throws std::runtime_error that names the file and what it differs in.
Part merged(const std::vector<std::filesystem::path>& files);

/// A part that is being made: a block is there as soon as it is added, whatever happens to the process.
class Journal {
 public:
  /// Goes on with what is there if it is of the same map; a block that was cut short is forgotten. Throws
  /// std::runtime_error if it is of another one, or another process writes it.
  Journal(std::filesystem::path file, const About& about);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const Blocks& blocks() const { return part_.blocks; }
  [[nodiscard]] const Part& part() const { return part_; }
  void add(int block, std::vector<Cell> cells);
  /// The map is written: the file is gone.
  void remove();

 private:
  void append(const std::string& bytes) const;

  std::filesystem::path path_;
  Part part_;
  int file_ = -1;
};

}  // namespace qvgen::map
