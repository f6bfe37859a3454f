// SPDX-License-Identifier: MIT
// Closed loops in TOML: the joints are a tree, and each [[loop]] says where two of its links meet.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// Names that [[loop]] tables and lists of joints may use; links of a TOML file are called by their joints.
struct LoopNames {
  std::vector<std::string> links, joints;
  /// Joints of several parts: the variables of these.
  std::map<std::string, std::vector<std::string>> composed = {};
  std::string told;  ///< how a message calls a link
  std::string hint;  ///< how a link is called
};

/// The largest number of loops of a robot.
inline constexpr std::size_t most_loops = 32;

/// Returns the [[loop]] tables; too many are reported.
std::vector<Table> loop_tables(const Table& root);

/// Reads a [[loop]]; links and joints are places among the names. Names that are unknown and a loop within
/// one link are reported with their place.
model::Loop read_loop(const Table& table, const LoopNames& names);

/// Reads `[[loop]]`, `actuated` and `outputs` into the mechanism, whose joints are known. Links that are
/// unknown, a loop within one link and joints that are named twice are reported with their place.
void read_loops(const Table& root, model::Mechanism& mechanism);

}  // namespace qvgen::description
