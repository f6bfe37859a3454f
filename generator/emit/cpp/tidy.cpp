// SPDX-License-Identifier: MIT
#include "emit/cpp/tidy.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace qvgen::emit {
namespace {

/// True if a line of code may be broken there: in front of operators, behind commas, opening brackets of
/// lists and "=".
bool may_break(const std::string& line, std::size_t at) {
  if (line[at - 1] != ' ') return false;
  const std::string_view before = std::string_view(line).substr(0, at - 1);
  const std::string_view behind = std::string_view(line).substr(at);
  for (const char* end : {",", " =", "{"})
    if (before.ends_with(end)) return true;
  for (const char* begin : {"+ ", "- ", "* ", "/ ", "? ", ": ", "&& ", "|| ", "// "})
    if (behind.starts_with(begin)) return true;
  return false;
}

/// How a character changes the number of open brackets; a template's have no space before them, a comparison
/// has.
int opens(const std::string& line, std::size_t at) {
  const char c = line[at];
  const char before = at == 0 ? ' ' : line[at - 1];
  if (c == '(' || c == '{' || c == '[' || (c == '<' && before != ' ')) return 1;
  if (c == ')' || c == '}' || c == ']' || (c == '>' && before != ' ' && before != '-')) return -1;
  return 0;
}

/// The last of the places with the fewest open brackets; 0 if there is none.
template <class MayBreak>
std::size_t last_outermost(const std::string& line, std::size_t begin, const MayBreak& may) {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  int depth = 0;
  bool text = false;
  for (std::size_t at = 0; at < line.size() && at <= line_width; ++at) {
    if (!text && at > begin && depth <= least && may(line, at)) {
      least = depth;
      best = at;
    }
    if (!text && line.compare(at, 3, "// ") == 0) break;  // words behind code
    if (line[at] == '"') text = !text;
    if (!text) depth += opens(line, at);
  }
  return best;
}

std::size_t break_of_code(const std::string& line, std::size_t indent) {
  const std::size_t best = last_outermost(line, indent + line_width / 4, may_break);
  if (best != 0) return best;
  return last_outermost(line, indent, [](const std::string& l, std::size_t at) { return l[at - 1] == '('; });
}

/// Returns where the last word begins that fits, else the first one behind a word that is too long; `next` is
/// what the next line begins with, so that a break before its end would leave the line as long as it is.
std::size_t break_of_comment(const std::string& line, std::size_t next) {
  std::size_t at = line.rfind(' ', line_width);
  if (at == std::string::npos || at < next) at = line.find(' ', std::max(next, line_width));
  return at == std::string::npos ? 0 : at + 1;
}

void put(std::string& result, const std::string& line, std::size_t end) {
  const std::size_t last = line.find_last_not_of(' ', end - 1);
  result += line.substr(0, last + 1) + "\n";
}

/// Returns what lines of a comment's prose begin with ("  /// "); empty for other lines, among them items of
/// lists and what is indented.
std::string prose_mark(const std::string& line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t slashes = std::min(line.find_first_not_of('/', indent), line.size());
  const std::size_t words = slashes + 1;
  const bool is_prose = slashes >= indent + 2 && words < line.size() && line[slashes] == ' ' &&
                        line[words] != ' ' && line.compare(words, 2, "- ") != 0;
  return is_prose ? line.substr(0, words) : "";
}

/// Puts a line in pieces that are short enough, and returns the last one.
std::string put_wrapped(std::string& result, std::string line) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const bool comment = line.compare(indent, 2, "//") == 0;
  const std::size_t words = comment ? std::min(line.find_first_not_of("/ ", indent), line.size()) : 0;
  std::string next = std::string(indent + 4, ' ');
  if (comment) {
    next = line.substr(0, words);
    if (line.compare(words, 2, "- ") == 0) next += "  ";
  }
  while (line.size() > line_width && line[indent] != '#') {
    const std::size_t at = comment ? break_of_comment(line, next.size()) : break_of_code(line, next.size());
    if (at <= next.size() || at >= line.size()) break;  // the rest would be no shorter, or nothing
    put(result, line, at);
    line = next + line.substr(at);
  }
  return line;
}

}  // namespace

std::string wrapped(const std::string& code) {
  std::string result;
  std::string carried;  // the last words of a comment's line, which go on in the next
  std::string begun;    // what lines of that comment begin with
  std::size_t begin = 0;
  for (std::size_t end = code.find('\n'); end != std::string::npos;
       begin = end + 1, end = code.find('\n', begin)) {
    std::string line = code.substr(begin, end - begin);
    const std::string mark = prose_mark(line);
    if (!carried.empty() && mark == begun) {
      line = carried + " " + line.substr(mark.size());
    } else if (!carried.empty()) {
      result += carried + "\n";
    }
    const std::string last = put_wrapped(result, line);
    carried = last != line && !mark.empty() ? last : "";
    begun = mark;
    if (carried.empty()) result += last + "\n";
  }
  if (!carried.empty()) result += carried + "\n";
  return result + code.substr(begin);
}

std::string without_spare_lines(const std::string& text) {
  std::string result;
  std::string last = "{";
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const std::string line = text.substr(start, end - start);
    start = end + 1;
    const bool in_namespace = last.rfind("namespace", 0) == 0;
    const bool spare = line.empty() && (last.empty() || (last.back() == '{' && !in_namespace));
    const bool closes =
        line.find_first_not_of(' ') != std::string::npos && line[line.find_first_not_of(' ')] == '}';
    if (spare) continue;
    if (closes && last.empty() && result.size() > 1 && line.size() == line.find('}') + 1) result.pop_back();
    result += line + "\n";
    last = line;
  }
  return result;
}

std::string tidy(const std::string& code) {
  return wrapped(without_needless_attributes(without_spare_lines(code)));
}

}  // namespace qvgen::emit
