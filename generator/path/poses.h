// SPDX-License-Identifier: MIT
// Poses of a path from a table: positions, orientations in one of three notations, and times if there are
// any. What cannot be followed is a mistake with its line; what is odd (a jump, two equal poses) is a
// warning.
#pragma once

#include <filesystem>
#include <istream>
#include <vector>

#include "description/reader.h"
#include "measured/table.h"

namespace qvgen::path {

/// One pose, w x y z and metres, as it goes to the program.
struct Sample {
  double w = 1, x = 0, y = 0, z = 0;
  double position[3] = {};
  double time;  ///< s; NaN without
};
static_assert(sizeof(Sample) == 64, "samples go to a file as they stand");

struct Poses {
  std::vector<Sample> samples;
  std::vector<int> lines;  ///< of each sample in its file
  bool timed = false;
  std::vector<description::Diagnostic> diagnostics;
  [[nodiscard]] bool good() const;  ///< no diagnostic is an error

  /// Length of the way of the tool's point, m.
  [[nodiscard]] double length() const;
};

struct PoseOptions {
  measured::TableOptions units;  ///< of columns whose header states none
  double speed = 0;              ///< m/s: gives times to a path without; 0: none
};

/// Reads a table with x y z, then qw qx qy qz, or roll pitch yaw (about fixed x, y, z), or rx ry rz (rotation
/// vector), or ax ay az (direction of the tool's z axis; it turns as little as can be from pose to pose), and
/// t if there is one.
Poses read_poses(std::istream& stream, const std::string& file, const PoseOptions& options);
Poses read_poses(const std::filesystem::path& path, const PoseOptions& options);

}  // namespace qvgen::path
