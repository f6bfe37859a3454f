// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "patterns.h"

namespace qvgen::test {

/// A description with its first joints alone, under another name, and no symbol that then occurs nowhere.
inline std::string cut_arm(const std::string& description, int joints, const std::string& name) {
  std::string text = description;
  if (const auto named = patterns::first(text, "name = \"[^\"]*\""))
    text.replace(named->at, named->groups[0].size(), "name = \"" + name + "\"");
  const auto headings = patterns::all(text, R"(\[\[(joint|dh|screw)\]\])");
  const auto kept = static_cast<std::size_t>(joints);
  if (headings.size() > kept) text.resize(headings[kept].at);
  std::istringstream lines(text);
  std::string result;
  bool defaults = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] == '[') defaults = line == "[defaults]";
    const auto symbol = patterns::whole(line, R"(^([a-zA-Z]\w*) = ("?[-0-9./]+"?)$)");
    const auto uses = [&](const std::string& word) {
      return patterns::all(text, "\\b" + word + "\\b").size() > 1;
    };
    if (!defaults || !symbol || uses(symbol->groups[1])) result += line + "\n";
  }
  return result;
}

/// The committed description of a robot.
inline std::string committed(const std::string& robot) {
  std::ostringstream text;
  text << std::ifstream(std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot + ".toml").rdbuf();
  return text.str();
}

}  // namespace qvgen::test
