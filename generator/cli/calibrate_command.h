// SPDX-License-Identifier: MIT
// `qvgen calibrate`: its arguments, its options on the command line, and the command.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "calibrate/data.h"
#include "calibrate/setup.h"
#include "description/reader.h"

namespace qvgen::cli {

/// Forms in which the arm is written.
enum class CalibratedFormat {
  toml,   ///< a description
  urdf,   ///< the input's URDF with other origins
  dh,     ///< rows of Denavit and Hartenberg with their differences
  hayati  ///< likewise, with a fifth number where axes are nearly parallel
};

struct CalibrateArguments {
  std::string robot;  ///< as the command line names it
  std::filesystem::path description;
  std::filesystem::path data;
  std::filesystem::path output, page;  ///< may be empty
  CalibratedFormat format = CalibratedFormat::toml;
  description::ReadOptions read;
  calibrate::DataOptions options;
  calibrate::Errors errors = calibrate::Errors::all;
  bool gears = false;              ///< eccentricity of gears, too
  bool bending = false;            ///< of joints under gravity, too
  std::size_t plan = 0;            ///< how many postures to plan; 0: calibrate
  std::filesystem::path spheres;   ///< for plans; may be empty
  double clearance = 0.01;         ///< m, between spheres
  std::vector<std::string> known;  ///< frames: tracker, target
};

/// Adds the command to a command line; its options write into `arguments`.
CLI::App* add_calibrate(CLI::App& app, CalibrateArguments& arguments);

int run_calibrate(const CalibrateArguments& arguments);

}  // namespace qvgen::cli
