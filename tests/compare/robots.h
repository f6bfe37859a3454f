// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
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

/// Descriptions of robots. Arms that differ from others by the sizes and senses of a few joints alone are
/// those of long runs, which set QVGEN_FORMULATIONS.
inline std::vector<std::filesystem::path> committed_robots() {
  static const std::set<std::string> twins{
      "cc",       "cn",      "cr",  "nc",  "nn",    "nr",         "ns",     "rc",        "rn",
      "rr",       "rs",      "sc",  "sn",  "sr",    "ss",         "rrp",    "rrr",       "rx90",
      "pan_tilt", "irb6640", "ur5", "rpp", "xarm6", "ns_numbers", "poe_6r", "rr_planar", "crx10ia"};
  const bool all = std::getenv("QVGEN_FORMULATIONS") != nullptr;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/robots"))
    if (entry.path().extension() == ".toml" && (all || twins.count(entry.path().stem().string()) == 0))
      files.push_back(entry.path());
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
