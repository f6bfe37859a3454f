// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "description/reader.h"

namespace qvgen::test {

inline model::Robot robot_of(const std::string& text) {
  const auto read = description::read_text(text, "robot.toml");
  if (!read.robot) throw std::runtime_error(text + to_string(read.diagnostics.front()));
  return *read.robot;
}

inline std::vector<std::filesystem::path> committed_robots() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

inline model::Robot committed_robot(const std::string& name) {
  return *description::read_file(std::string(QVGEN_SOURCE_DIR "/generator/robots/") + name + ".toml").robot;
}

/// How many random arms: QVGEN_FORMULATIONS, or the given number.
inline std::uint32_t random_arms(std::uint32_t number) {
  const char* wanted = std::getenv("QVGEN_FORMULATIONS");
  return wanted ? static_cast<std::uint32_t>(std::strtoul(wanted, nullptr, 10)) : number;
}

}  // namespace qvgen::test
