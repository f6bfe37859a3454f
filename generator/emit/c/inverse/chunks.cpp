// SPDX-License-Identifier: MIT
#include "emit/c/inverse/chunks.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <vector>

namespace qvgen::emit::c {
namespace {

bool begins_with(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The identifiers of a text, in order; comments and members are left out. `calls`: only those in front of a
/// bracket.
std::vector<std::string> names_in(const std::string& text, bool calls = false) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (is_name(text[at])) {
      std::size_t end = at;
      while (end < text.size() && is_name(text[end])) ++end;
      const bool is_member = at > 0 && (text[at - 1] == '.' || text[at - 1] == '>');
      const bool is_call = end < text.size() && text[end] == '(';
      if (!is_member && (is_call || !calls)) names.push_back(text.substr(at, end - at));
      at = end;
    } else {
      ++at;
    }
  }
  return names;
}

/// A definition with the comment in front of it.
struct Chunk {
  std::string comment;
  std::vector<std::string> lines;

  [[nodiscard]] std::string code() const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }
  [[nodiscard]] const std::string& head() const { return lines.front(); }
  [[nodiscard]] bool is_function() const {
    return !begins_with(head(), "typedef") && !begins_with(head(), "enum") &&
           !begins_with(head(), "static const ") && head().find('(') != std::string::npos;
  }
  [[nodiscard]] bool is_public() const { return is_function() && !begins_with(head(), "static"); }
};

bool is_comment(const std::string& line) { return begins_with(line, "//") || begins_with(line, "/*"); }

/// Braces that a line opens and does not close.
std::ptrdiff_t opened(const std::string& line) {
  const std::string code = line.substr(0, line.find("//"));
  return std::count(code.begin(), code.end(), '{') - std::count(code.begin(), code.end(), '}');
}

std::vector<Chunk> chunks_of(const std::string& source) {
  std::vector<Chunk> chunks;
  Chunk chunk;
  std::ptrdiff_t depth = 0;
  std::istringstream stream(source);
  for (std::string line; std::getline(stream, line);) {
    if (chunk.lines.empty() && line.empty()) {
      chunk.comment.clear();
      continue;
    }
    if (chunk.lines.empty() && is_comment(line)) {
      chunk.comment += line + "\n";
      continue;
    }
    if (line.empty()) continue;
    chunk.lines.push_back(line);
    depth += opened(line);
    if (depth > 0 || (line.back() != ';' && line.back() != '}')) continue;
    chunks.push_back(chunk);
    chunk = {};
  }
  return chunks;
}

/// Returns the names that a definition defines.
std::set<std::string> defined(const Chunk& chunk) {
  const std::string code = chunk.code();
  if (begins_with(chunk.head(), "enum") || begins_with(chunk.head(), "typedef enum")) {
    const auto names = names_in(code);
    return {names.begin(), names.end()};
  }
  if (begins_with(chunk.head(), "typedef")) return {names_in(chunk.lines.back()).back()};
  const std::size_t end = std::min(code.find('('), std::min(code.find('='), code.find('[')));
  return {names_in(code.substr(0, end)).back()};
}

/// Chunks that the public ones reach, in their order.
std::vector<Chunk> reached(const std::vector<Chunk>& chunks) {
  std::vector<bool> is_needed(chunks.size(), false);
  std::set<std::string> named, called;
  const auto take = [&](std::size_t i) {
    is_needed[i] = true;
    const std::string code = chunks[i].code();
    for (const std::string& name : names_in(code)) named.insert(name);
    for (const std::string& name : names_in(code, true)) called.insert(name);
  };
  for (std::size_t i = 0; i < chunks.size(); ++i)
    if (chunks[i].is_public() || begins_with(chunks[i].head(), "const ")) take(i);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      if (is_needed[i]) continue;
      const std::set<std::string>& wanted = chunks[i].is_function() ? called : named;
      const std::set<std::string> names = defined(chunks[i]);
      if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return wanted.count(name) > 0; }))
        continue;
      take(i);
      grows = true;
    }
  }
  std::vector<Chunk> result;
  for (std::size_t i = 0; i < chunks.size(); ++i)
    if (is_needed[i]) result.push_back(chunks[i]);
  return result;
}

std::string text_of(const std::vector<Chunk>& chunks) {
  std::string text;
  for (const Chunk& chunk : chunks) text += (text.empty() ? "" : "\n") + chunk.comment + chunk.code();
  return text;
}

}  // namespace

std::string needed(const std::string& source) { return text_of(reached(chunks_of(source))); }

std::string needed_by(const std::string& function, const std::string& source) {
  std::vector<Chunk> chunks = chunks_of(source);
  chunks.erase(
      std::remove_if(chunks.begin(), chunks.end(), [](const Chunk& each) { return each.is_public(); }),
      chunks.end());
  for (const Chunk& each : chunks_of(function)) chunks.push_back(each);
  return text_of(reached(chunks));
}

}  // namespace qvgen::emit::c
