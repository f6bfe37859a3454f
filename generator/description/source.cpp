// SPDX-License-Identifier: MIT
#include "description/source.h"

#include <utility>

namespace qvgen::description {
namespace {

/// Byte offset of a column (from 1), columns being UTF-8 characters.
std::size_t byte_of_column(const std::string& line, std::size_t column) {
  std::size_t byte = 0;
  for (std::size_t current = 1; byte < line.size() && current < column; ++current) {
    ++byte;
    while (byte < line.size() && (static_cast<unsigned char>(line[byte]) & 0xC0U) == 0x80U) ++byte;
  }
  return byte;
}

}  // namespace

Place begin_of(const toml::source_region& region) {
  if (!region.begin) return {};
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Source::Source(std::string_view text, std::string file) : file_(std::move(file)) {
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines_.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::string Source::slice(const toml::source_region& region) const {
  if (!region.begin || region.begin.line != region.end.line || region.begin.line > lines_.size()) return {};
  const std::string& line = lines_[region.begin.line - 1];
  const std::size_t begin = byte_of_column(line, region.begin.column);
  return line.substr(begin, byte_of_column(line, region.end.column) - begin);
}

}  // namespace qvgen::description
