// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace qvgen::description {

/// A position in the text, counted from 1; columns in characters.
struct Place {
  int line = 1;
  int column = 1;
  int file = 0;  ///< 0: the description itself; from 1: a file that it names (Context::files)
  friend bool operator<(const Place& a, const Place& b) {
    if (a.file != b.file) return a.file < b.file;
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  }
};

Place begin_of(const toml::source_region& region);

/// The description's text, kept so that numbers can be read as they were written.
class Source {
 public:
  Source(std::string_view text, std::string file);
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Returns the text of a region within one line; empty if it spans several.
  [[nodiscard]] std::string slice(const toml::source_region& region) const;

 private:
  std::string file_;
  std::vector<std::string> lines_;
};

}  // namespace qvgen::description
