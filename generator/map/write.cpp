// SPDX-License-Identifier: MIT
#include "map/write.h"

#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "map/quantities.h"
#include "pipeline/files.h"

namespace qvgen::map {
namespace {

const std::map<std::string, std::string (*)(const Part&)>& writers() {
  static const std::map<std::string, std::string (*)(const Part&)> all{
      {".npz", npz_text}, {".part", part_text}, {".svg", svg_text}, {".vtk", vtk_text}};
  return all;
}

}  // namespace

bool is_suffix(const std::string& suffix) { return writers().count(suffix) > 0; }

void write_map(const Part& part, const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  const std::string missing = missing_blocks(part.blocks);
  if (suffix != ".part" && !missing.empty())
    throw std::runtime_error(
        fmt::format("{} cannot be written: the blocks {} are missing; compute them with "
                    "--blocks, with all other options as they were",
                    file.string(), missing));
  pipeline::replace_file(file, writers().at(suffix)(part), file.string() + ".new");
}

}  // namespace qvgen::map
