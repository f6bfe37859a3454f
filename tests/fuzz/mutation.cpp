// SPDX-License-Identifier: MIT
#include "mutation.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace qvgen::test {
namespace {

std::size_t below(std::size_t count, std::mt19937& random) {
  return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

template <class T>
const T& one_of(const std::vector<T>& values, std::mt19937& random) {
  return values[below(values.size(), random)];
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

const std::vector<std::string> values = {
    "0",      "-1",        "1e300",    "1e-300",  "nan",      "inf",         "1/0",  "1/3",
    "0.1",    "1.5708",    "90 deg",   "30 deg",  "-0.7071",  "theta1",      "a1",   "pi",
    "pi/2",   "sqrt(2)",   "sqrt(-1)", "cos(a1)", "l1/l2",    "2^64",        "a1^2", "\"\"",
    "\"+z\"", "[0, 0, 0]", "[1, 0]",   "true",    "\"free\"", "\"a1 + b1\"", "{}",   "0.000001"};
const std::vector<std::string> pieces = {
    "-",  "\"", "[", "]",  "x",    " ", "\n", "(",       ")",  "=",           "é",        "{",
    "'",  "^9", "<", "/>", "&lt;", "#", "\\", "\\u202E", "\t", "[[joint]]\n", "<joint/>", " pos=\"0 0\"",
    "1e9"};

void change_characters(std::string& text, std::mt19937& random) {
  const std::size_t at = below(text.size(), random);
  const std::size_t length = std::min(1 + below(12, random), text.size() - at);
  switch (below(3, random)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    default:
      text.insert(at, one_of(pieces, random));
  }
}

/// A number or a word gives way to another value.
void change_value(std::string& text, std::mt19937& random) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_';
  };
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(below(text.size(), random));
  const auto start = std::find_if(from, text.end(), is_part);
  const auto end = std::find_if_not(start, text.end(), is_part);
  text.replace(start, end, one_of(values, random));
}

void change_lines(std::string& text, const std::string& other, std::mt19937& random) {
  std::vector<std::string> lines = lines_of(text);
  if (lines.empty()) return;
  const auto place = [&] { return lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size(), random)); };
  switch (below(4, random)) {
    case 0:
      lines.erase(place());
      break;
    case 1: {
      const std::string line = *place();
      lines.insert(place(), line);
      break;
    }
    case 2:
      std::swap(*place(), *place());
      break;
    default: {
      const std::vector<std::string> from = lines_of(other);
      if (!from.empty()) lines.insert(place(), one_of(from, random));
    }
  }
  text = joined(lines);
}

}  // namespace

std::string mutated(const std::vector<std::string>& corpus, std::mt19937& random) {
  std::string text = one_of(corpus, random);
  const std::size_t slips = 1 + below(3, random);
  for (std::size_t i = 0; i < slips; ++i) {
    if (text.empty()) return text;
    const std::size_t kind = below(4, random);
    if (kind == 0)
      change_characters(text, random);
    else if (kind == 1)
      change_lines(text, one_of(corpus, random), random);
    else
      change_value(text, random);
  }
  return text;
}

}  // namespace qvgen::test
