// SPDX-License-Identifier: MIT
// The command `identify`: inertias, rotor inertias and friction of an arm from logs of its motion.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "description/reader.h"

namespace qvgen::cli {

struct IdentifyArguments {
  std::filesystem::path description;
  description::ReadOptions read;
  std::vector<std::string> logs, hold_out, payload;
  std::filesystem::path output, table, page;   ///< may be empty
  bool stribeck = false, temperature = false;  ///< friction beyond the drives'
  bool urdf = false;                           ///< the output is the input's URDF with numbers
  std::vector<std::string> drives;             ///< names of drive parameters; empty: all
  std::vector<double> torque_constants;        ///< Nm (N) for an ampere, a joint each
  std::optional<double> gravity, mass, standstill;
  std::optional<double> plan;  ///< s: a motion is planned, and no log is read
  std::optional<int> window;
};

/// Names of the kinds of drive parameters, in the order of derive::dynamics::DriveParameter.
const std::vector<std::string>& drive_names();

/// Prints what the logs tell, and writes the description with numbers.
int run_identify(const IdentifyArguments& arguments);

}  // namespace qvgen::cli
