// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>

#include "emit/cpp/tidy.h"

namespace qvgen::emit {
namespace {

const std::string attribute = "[[maybe_unused]] ";

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The place behind the comment or text that begins at one, or the place itself.
std::size_t behind_text(const std::string& code, std::size_t at) {
  if (code.compare(at, 2, "//") == 0) return std::min(code.find('\n', at), code.size());
  if (code[at] == '"') return std::min(code.find('"', at + 1), code.size() - 1) + 1;
  return at;
}

/// Returns the end of the declaration that begins here: before = , ; or a closing bracket, outside of <> and
/// ().
std::size_t end_of_declaration(const std::string& code, std::size_t at) {
  int depth = 0;
  for (; at < code.size(); ++at) {
    const char c = code[at];
    if (depth == 0 && (c == ',' || c == ')' || c == '=' || c == ';' || c == '{')) break;
    depth += c == '<' || c == '(' ? 1 : c == '>' || c == ')' ? -1 : 0;
  }
  return at;
}

std::string last_name(const std::string& declaration) {
  std::size_t end = declaration.size();
  while (end > 0 && !is_name(declaration[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_name(declaration[begin - 1])) --begin;
  return declaration.substr(begin, end - begin);
}

/// True if the name stands at a place, by itself and not as a member of something.
bool stands_at(const std::string& code, std::size_t at, const std::string& name) {
  if (code.compare(at, name.size(), name) != 0) return false;
  if (at + name.size() < code.size() && is_name(code[at + name.size()])) return false;
  return at == 0 ||
         !(is_name(code[at - 1]) || code[at - 1] == '.' || code[at - 1] == ':' || code[at - 1] == '>');
}

/// True if the code of the scope in which a thing is declared names it: the function's body for a parameter,
/// up to the end of the block for a variable. A function without a body names nothing.
bool is_used(const std::string& code, std::size_t at, const std::string& name) {
  int braces = 0;
  bool parameter = false;
  int brackets = 0;
  while (at < code.size()) {
    if (const std::size_t next = behind_text(code, at); next != at) {
      at = next;
      continue;
    }
    const char c = code[at];
    brackets += c == '(' ? 1 : c == ')' ? -1 : 0;
    parameter = parameter || brackets < 0;
    if (parameter && braces == 0 && c == ';') return false;
    braces += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (braces < 0 || (parameter && braces == 0 && c == '}')) return false;
    if (stands_at(code, at, name)) return true;
    at += 1;
  }
  return false;
}

}  // namespace

std::string without_needless_attributes(const std::string& code) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = code.find(attribute); at != std::string::npos; at = code.find(attribute, done)) {
    const std::size_t begin = at + attribute.size();
    const std::size_t end = end_of_declaration(code, begin);
    // `using Name [[maybe_unused]] = ...` has its name before the attribute.
    const std::string name =
        end == begin ? last_name(code.substr(done, at - done)) : last_name(code.substr(begin, end - begin));
    result += code.substr(done, at - done);
    if (!is_used(code, end, name)) result += attribute;
    done = begin;
  }
  return result + code.substr(done);
}

}  // namespace qvgen::emit
