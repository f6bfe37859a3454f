// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace qvgen::exact {

/// FNV-1a: the same number on every machine, which std::hash does not promise.
constexpr std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325ULL;
  for (const char character : text)
    value = (value ^ static_cast<unsigned char>(character)) * 0x100000001b3ULL;
  return value;
}

/// Order-dependent mix of two hashes (the finaliser of splitmix64).
constexpr std::uint64_t combine(std::uint64_t a, std::uint64_t b) {
  std::uint64_t value = a * 0x9e3779b97f4a7c15ULL + b;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

}  // namespace qvgen::exact
