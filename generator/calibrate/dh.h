// SPDX-License-Identifier: MIT
// The arm before and after as rows of Denavit and Hartenberg, and the differences, which controllers take.
//
// A row is turn(z, theta) shift(z, d) shift(x, a) turn(x, alpha) turn(y, beta); the joint's value is added to
// theta or, for a slide, to d. Axes that are nearly parallel have their common normal far away: the four
// numbers of such rows change by metres for an error of a milliradian. Hayati and Mirmirani (1985) keep d and
// add beta there.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

struct DhRow {
  double theta = 0, d = 0, a = 0, alpha = 0, beta = 0;  ///< rad, m
};

/// World -> tool: base * rows * tool.
struct DhRows {
  Eigen::Isometry3d base;
  std::vector<DhRow> rows;  ///< a joint each
  Eigen::Isometry3d tool;
};

enum class DhForm {
  classic,  ///< four numbers, beta is zero
  hayati    ///< rows of axes that are nearly parallel in the description have beta, and d as described
};

struct DhChange {
  DhRows before, after;
};
DhChange dh_change(const Calibration& calibration, DhForm form);

/// Returns comma-separated values: a row for each joint with its numbers after, then the differences; base
/// and tool stand in comments.
std::string dh_text(const DhChange& change, DhForm form);

}  // namespace qvgen::calibrate
