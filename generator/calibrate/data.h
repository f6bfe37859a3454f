// SPDX-License-Identifier: MIT
// Measurements of an arm from a table: values q1, q2, ... of joints and motors (or their own names), and what
// was measured there. The columns say which kind of data it is:
//
//     x y z  with qw qx qy qz, or roll pitch yaw, or rx ry rz    poses (rx ry rz: axis times angle)
//     x y z                                                      positions
//     distance                                                   from a fixed point, numbered by `surface`
//     plane or sphere                                            the number of the surface that was touched
//
// `target` numbers the targets on the tool; `sigma` and `sigma_angle` are standard deviations.
#pragma once

#include <filesystem>

#include "calibrate/setup.h"
#include "description/reader.h"
#include "measured/table.h"

namespace qvgen::calibrate {

struct Measurement {
  int line = 0;
  std::vector<double> q;  ///< rad, m; one for each joint that follows none, and each motor
  std::size_t target = 0, surface = 0;
  Rigid<double> pose;   ///< the rotation is the identity for positions
  double distance = 0;  ///< m
  double sigma = 0, sigma_angle = 0;
};

struct DataOptions {
  double angle_unit = 1, length_unit = 1;  ///< of columns whose header states none
  double sigma = 0, sigma_angle = 0;       ///< m, rad; 0: not said
  bool camera = false;                     ///< poses are those of a board, seen by a camera on the tool
  std::vector<std::string> ignored;        ///< columns
};

/// Deviations that weigh positions against angles where none are said: m, rad.
inline constexpr double usual_sigma = 1e-4, usual_sigma_angle = 1e-4;

struct DataSet {
  std::string file;
  Data data = Data::pose;
  std::vector<Measurement> rows;
  std::vector<int> targets, surfaces;  ///< as the file numbers them
  bool sigma_known = false;
};

struct DataResult {
  DataSet set;
  std::vector<description::Diagnostic> diagnostics;
  bool good = false;
};

DataResult read_data(const std::filesystem::path& path, const model::Robot& robot,
                     const DataOptions& options);

}  // namespace qvgen::calibrate
