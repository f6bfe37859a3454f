// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include <qvgen/path/record.h>

/// Results as JSON, piece by piece, for the program that `qvgen path` runs. Numbers have all their digits;
/// what is not finite is null.
namespace qvgen::path::json {

inline std::string text(double value) {
  if (!std::isfinite(value)) return "null";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

inline std::string text(const Values& q) {
  std::string list;
  for (int i = 0; i < 6; ++i) list += (i == 0 ? "[" : ",") + text(q[i]);
  return list + "]";
}

inline const char* text(Cause cause) {
  constexpr const char* names[] = {"path_end", "meeting", "boundary", "flip", "limit", "unclear"};
  return names[static_cast<std::size_t>(cause)];
}

inline std::string text(const End& end) {
  return "{\"s\":" + text(end.s) + ",\"cause\":\"" + text(end.cause) +
         "\",\"partner\":" + std::to_string(end.partner) + ",\"upper\":" + (end.is_upper ? "true" : "false") +
         ",\"free\":" + std::to_string(end.free) + ",\"q\":" + text(end.q) + "}";
}

}  // namespace qvgen::path::json
