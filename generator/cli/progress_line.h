// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace qvgen::cli {

/// One line on stderr that is rewritten as robots finish; silent where nobody looks.
class ProgressLine {
 public:
  explicit ProgressLine(std::size_t total);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();
  void finished(const std::string& robot);
  /// Anything else in the same place.
  void say(const std::string& text) const;

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool visible_;
};

}  // namespace qvgen::cli
