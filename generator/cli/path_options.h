// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "description/reader.h"

namespace qvgen::cli {

struct PathArguments {
  std::filesystem::path description;
  description::ReadOptions read;
  std::string robot;            ///< as it was named
  std::filesystem::path poses;  ///< table of poses
  std::vector<std::filesystem::path> outputs;
  std::vector<std::string> limits;  ///< NAME=LOWER:UPPER
  std::string held;                 ///< NAME=VALUE
  std::vector<std::string> free;    ///< what is free, NAME or NAME=RANGE; empty for nothing
  std::vector<double> preferred;    ///< joints to be near to, rad or m
  int values = 72;                  ///< of what is free, at each pose
  bool without_limits = false;
  bool screw = false, spline = false;
  double blend = 0;   ///< radius, m; 0 without
  std::string range;  ///< LOWER:UPPER of what is free; empty without
  bool prove = false;
  std::vector<double> accelerations, joint_speeds;  ///< one, or one for each joint; empty without
  std::vector<double> joint_jerks;                  ///< likewise
  std::vector<std::string> joint_torques;           ///< likewise, or "description"
  double speed = 0;
  std::string length_unit = "m", angle_unit = "rad";
  std::filesystem::path known_robots;
  std::optional<std::filesystem::path> source_tree;
  std::uint64_t tool = 0;  ///< a number that another build of the tool has not
};

/// Adds the command `path`.
CLI::App* add_path(CLI::App& app, PathArguments& arguments);

/// All continuous motions of the joints that follow a path.
int run_path(const PathArguments& arguments);

}  // namespace qvgen::cli
