// SPDX-License-Identifier: MIT
// Logs of an arm's motion as files: columns named q1, qd1, qdd1 and torque1 (or current1), a joint each.
#pragma once

#include <string>
#include <vector>

#include "identify/motion_log.h"
#include "measured/table.h"
#include "model/robot.h"

namespace qvgen::identify {

struct LogOptions {
  /// Nm (N) of each joint for an ampere of its motor, gear included: currents are read in place of torques.
  std::vector<double> torque_constants = {};
  /// False: a file without torques, a planned motion.
  bool torques = true;
  /// True: temperatures are read too, "temperature [degC]" of the whole arm, or temperature1, ... of each
  /// joint.
  bool temperature = false;
};

/// A log, with the lines of its samples; or the mistakes of its file.
struct LogResult {
  MotionLog log;
  std::vector<int> lines;
  std::vector<description::Diagnostic> diagnostics;
  [[nodiscard]] bool good() const;  ///< no diagnostic is an error
};

/// Returns the columns that a log of the robot has.
std::vector<measured::Wanted> log_columns(const model::Robot& robot, const LogOptions& options);

/// Reads a log and looks for what cannot be: time that goes back, joints far beyond their limits, rates that
/// are not those of the positions. Torques of a motor at its bound are taken out, with a note.
LogResult read_log(const std::string& file, const model::Robot& robot, const LogOptions& options);
/// Makes a log of a table that has been read.
LogResult log_of(const measured::TableResult& read, const model::Robot& robot, const LogOptions& options);

}  // namespace qvgen::identify
