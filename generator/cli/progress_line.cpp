// SPDX-License-Identifier: MIT
#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

namespace qvgen::cli {

ProgressLine::ProgressLine(std::size_t total) : total_(total), visible_(::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::finished(const std::string& robot) {
  ++done_;
  say(fmt::format("[{}/{}] {}", done_, total_, robot));
}

void ProgressLine::say(const std::string& text) const {
  if (!visible_) return;
  fmt::print(stderr, "\r\033[K{}", text);
  std::fflush(stderr);
}

}  // namespace qvgen::cli
