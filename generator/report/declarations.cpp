// SPDX-License-Identifier: MIT
#include "report/declarations.h"

#include <sstream>

namespace qvgen::report {
namespace {

bool begins(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

void append_line(std::vector<std::string>& paragraphs, std::string line) {
  line.erase(0, begins(line, "/// ") ? 4 : 3);
  if (line.empty() || paragraphs.empty()) paragraphs.emplace_back();
  if (line.empty()) return;
  paragraphs.back() += (paragraphs.back().empty() ? "" : " ") + line;
}

/// The identifier before the first bracket of arguments.
std::string name_of(const std::string& signature) {
  const std::size_t open = signature.find('(');
  if (open == std::string::npos) return "";
  const std::size_t start = signature.find_last_of(" >&*\n", open - 1);
  return start == std::string::npos ? "" : signature.substr(start + 1, open - start - 1);
}

}  // namespace

std::vector<Declaration> declarations_in(const std::string& header) {
  std::vector<Declaration> result;
  Declaration current;
  bool open = false;  ///< a signature that goes on
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    if (begins(line, "///")) {
      if (!open) append_line(current.comment, line);
      continue;
    }
    if (begins(line, "template <") && !open) continue;
    const bool other = begins(line, "struct") || begins(line, "using") || begins(line, "inline constexpr") ||
                       begins(line, "extern") || begins(line, "//") || begins(line, "#") ||
                       begins(line, "class");
    if (!open && (line.empty() || other || line.front() == ' ' || line.front() == '}')) {
      current = {};
      continue;
    }
    current.signature += (open ? "\n" : "") + line;
    open = line.find(';') == std::string::npos && line.find('{') == std::string::npos;
    if (open) continue;
    current.signature.erase(current.signature.find_last_not_of(" {;") + 1);
    current.name = name_of(current.signature);
    if (!current.name.empty() && !current.comment.empty()) result.push_back(current);
    current = {};
  }
  return result;
}

}  // namespace qvgen::report
