// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace qvgen::test {

/// A description with its first joints alone, under another name, and no symbol that then occurs nowhere.
inline std::string cut_arm(const std::string& description, int joints, const std::string& name) {
  std::string text = std::regex_replace(description, std::regex("name = \"[^\"]*\""),
                                        "name = \"" + name + "\"", std::regex_constants::format_first_only);
  const std::regex heading(R"(\[\[(joint|dh|screw)\]\])");
  int seen = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), heading), end; at != end; ++at) {
    if (seen++ < joints) continue;
    text.resize(static_cast<std::size_t>(at->position()));
    break;
  }
  std::istringstream lines(text);
  std::string result;
  const std::regex symbol(R"(^([a-zA-Z]\w*) = ("?[-0-9./]+"?)$)");
  bool defaults = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] == '[') defaults = line == "[defaults]";
    std::smatch match;
    const bool is_symbol = defaults && std::regex_match(line, match, symbol);
    const auto uses = [&](const std::string& word) {
      const std::regex whole("\\b" + word + "\\b");
      return std::distance(std::sregex_iterator(text.begin(), text.end(), whole), std::sregex_iterator()) > 1;
    };
    if (!is_symbol || uses(match[1].str())) result += line + "\n";
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
