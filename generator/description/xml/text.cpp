// SPDX-License-Identifier: MIT
#include "description/xml/text.h"

#include <algorithm>
#include <cstdint>

namespace qvgen::description::xml {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// True for the two bytes that a file in UTF-16 begins with; `big`: the high byte of each unit comes first.
bool has_utf16_mark(std::string_view file, bool big) {
  return file.substr(0, 2) == (big ? "\xFE\xFF" : "\xFF\xFE");
}

void append(std::string& text, std::uint32_t code) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
  if (code < 0x80U) return byte(code);
  if (code < 0x800U) {
    byte(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000U) {
      byte(0xE0U | code >> 12U);
    } else {
      byte(0xF0U | code >> 18U);
      byte(0x80U | (code >> 12U & 0x3FU));
    }
    byte(0x80U | (code >> 6U & 0x3FU));
  }
  byte(0x80U | (code & 0x3FU));
}

/// Returns UTF-16 behind its mark as UTF-8; half a character becomes a question mark.
std::string from_utf16(std::string_view file, bool big) {
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(file[at]),
               second = static_cast<unsigned char>(file[at + 1]);
    return big ? first * 256U + second : second * 256U + first;
  };
  std::string text;
  for (std::size_t at = 2; at + 1 < file.size(); at += 2) {
    const std::uint32_t high = unit(at), low = at + 3 < file.size() ? unit(at + 2) : 0;
    const bool pair = high >= 0xD800U && high < 0xDC00U && low >= 0xDC00U && low < 0xE000U;
    if (pair) at += 2;
    const bool half = !pair && high >= 0xD800U && high < 0xE000U;
    append(text, pair   ? 0x10000U + ((high - 0xD800U) << 10U) + (low - 0xDC00U)
                 : half ? std::uint32_t('?')
                        : high);
  }
  return text;
}

/// Returns where the first thing begins that is neither blank nor a comment.
std::size_t behind_comments(std::string_view text) {
  std::size_t at = 0;
  for (;;) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos || text.substr(at, 4) != "<!--") return std::min(at, text.size());
    const std::size_t end = text.find("-->", at + 4);
    if (end == std::string_view::npos) return text.size();
    at = end + 3;
  }
}

/// The encoding that a declaration names, or none.
std::string encoding_of(std::string_view declaration) {
  const std::size_t key = declaration.find("encoding");
  const std::size_t open = key == std::string_view::npos ? key : declaration.find_first_of("\"'", key);
  if (open == std::string_view::npos) return "";
  const std::size_t close = declaration.find(declaration[open], open + 1);
  return close == std::string_view::npos ? "" : std::string(declaration.substr(open + 1, close - open - 1));
}

Place place_of(std::string_view text, std::size_t offset, int file) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t start = before.rfind('\n') + 1;
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(offset - start) + 1, file};
}

}  // namespace

bool is_utf16_xml(std::string_view file) {
  if (!has_utf16_mark(file, true) && !has_utf16_mark(file, false)) return false;
  const std::string text = from_utf16(file.substr(0, 1000), has_utf16_mark(file, true));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '<';
}

Text readable(Context& context, std::string_view bytes, int file) {
  Text text{std::string(bytes), ""};
  for (const bool big : {true, false})
    if (has_utf16_mark(bytes, big)) {
      text = {from_utf16(bytes, big), "UTF-8"};
      context.note({1, 1, file}, "the file is in UTF-16 and read so", "UTF-8 is more usual");
    }
  std::string& all = text.utf8;
  if (all.compare(0, utf8_mark.size(), utf8_mark) == 0) std::fill_n(all.begin(), utf8_mark.size(), ' ');
  const std::size_t mark = all.find_first_not_of(' ') == utf8_mark.size() ? utf8_mark.size() : 0;
  const std::size_t begin = behind_comments(all);
  const std::size_t end = all.find("?>", begin);
  // At the very beginning a declaration is Expat's; behind a mark, which is blank now, it would be none.
  if (begin == 0 || all.compare(begin, 6, "<?xml ") != 0 || end == std::string::npos) return text;
  if (text.encoding.empty()) text.encoding = encoding_of(std::string_view(all).substr(begin, end - begin));
  if (begin > mark)
    context.warning(place_of(all, begin, file),
                    "the XML declaration is not the beginning of the file: it is left out", "put it first");
  for (std::size_t i = begin; i < end + 2; ++i)
    if (all[i] != '\n') all[i] = ' ';
  return text;
}

}  // namespace qvgen::description::xml
