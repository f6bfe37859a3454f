// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace qvgen::map {

/// CRC-32 as zip files have it.
inline std::uint32_t checksum(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      entries.at(i) = i;
      for (int bit = 0; bit < 8; ++bit)
        entries.at(i) = (entries.at(i) >> 1U) ^ ((entries.at(i) & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return entries;
  }();
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (sum >> 8U);
  return ~sum;
}

/// The bytes of a number, the lowest first.
template <class Number>
void append_number(std::string& to, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    to += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xFFU);
}

}  // namespace qvgen::map
