// SPDX-License-Identifier: MIT
#include "description/plain_text.h"

#include <cstdint>
#include <cstdio>
#include <utility>

namespace qvgen::description {
namespace {

/// The character that begins here, and its length in bytes. The text is valid UTF-8, or its bytes count as
/// characters.
std::pair<std::uint32_t, std::size_t> character_at(std::string_view text, std::size_t place) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t first = byte(place);
  const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 1 || place + length > text.size()) return {first, 1};
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(place + i) & 0x3FU);
  return {code, length};
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }
bool is_separator(std::uint32_t code) { return code == 0x2028 || code == 0x2029; }
bool turns_direction(std::uint32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string spelt(std::uint32_t code) {
  char text[16];
  std::snprintf(text, sizeof text, code < 0x100 ? "\\x%02X" : "\\u%04X", static_cast<unsigned>(code));
  return text;
}

}  // namespace

std::string problem_of_text(std::string_view text) {
  for (std::size_t place = 0; place < text.size();) {
    const auto [code, length] = character_at(text, place);
    if (is_control(code) || is_separator(code)) return "has the control character " + spelt(code);
    if (turns_direction(code)) return "has a mark that turns the direction of writing, " + spelt(code);
    place += length;
  }
  // Either would make a comment of C or C++ go on in the next line; C99 reads the second as the first.
  const std::string_view end = text.substr(0, text.find_last_not_of(' ') + 1);
  if (!end.empty() && end.back() == '\\') return "ends with a backslash";
  if (end.size() >= 3 && end.substr(end.size() - 3) == "?\?/")
    return "ends with ?\?/, which C reads as a backslash";
  return {};
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t place = 0; place < text.size();) {
    const auto [code, length] = character_at(text, place);
    const bool plain = !is_control(code) && !is_separator(code) && !turns_direction(code);
    result += plain ? std::string(text.substr(place, length)) : spelt(code);
    place += length;
  }
  return result;
}

}  // namespace qvgen::description
