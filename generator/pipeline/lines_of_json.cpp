// SPDX-License-Identifier: MIT
#include "pipeline/lines_of_json.h"

#include <algorithm>

namespace qvgen::pipeline {
namespace {

using nlohmann::ordered_json;

bool is_flat(const ordered_json& json) {
  return std::none_of(json.begin(), json.end(), [](const auto& each) { return each.is_structured(); });
}

void write(const ordered_json& json, const std::string& indent, std::string& text) {
  if (!json.is_structured() || is_flat(json)) {
    text += json.dump();
    return;
  }
  text += json.is_object() ? "{" : "[";
  const std::string inner = indent + ' ';
  const char* before = "\n";
  for (const auto& [key, value] : json.items()) {
    text += before + inner;
    if (json.is_object()) text += ordered_json(key).dump() + ": ";
    write(value, inner, text);
    before = ",\n";
  }
  text += "\n" + indent + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string lines_of_json(const ordered_json& json) {
  std::string text;
  write(json, "", text);
  return text + "\n";
}

}  // namespace qvgen::pipeline
