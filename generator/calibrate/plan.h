// SPDX-License-Identifier: MIT
// Which postures to measure next: those that tell most of what is not known yet. Of random ones within the
// limits the one is taken whose measurement makes the determinant of the information grow most (D-optimal),
// then the next beside it. Where spheres stand for the links, only postures that keep these apart are taken,
// each to be reached from the one before by a straight motion of the joints.
#pragma once

#include "calibrate/calibration.h"
#include "calibrate/clearance.h"

namespace qvgen::calibrate {

struct Plan {
  std::vector<std::vector<double>>
      postures;                       ///< rad, m; one value for each joint that follows none and each motor
  double before = 0, after = 0;       ///< expected deviation of a predicted position (m)
  std::vector<std::string> touching;  ///< links whose spheres meet in every posture, in words
};

/// Plans so many postures for a kind of data, after those of `set`, which may be empty. The state is where
/// derivatives are taken. Standard deviations are those of the first row, or the usual ones. Throws
/// std::runtime_error where hardly any posture keeps the clearance, or none is reached from the one before.
Plan plan(const model::Robot& robot, const Identifiable& can, const State& state, const DataSet& set,
          std::size_t count, Clearance clearance);

/// Returns a state of the nominal arm with targets off its axes, for plans without data.
State state_without_data(const Identifiable& can);

/// Returns the postures as a table with a header, in degrees and millimetres.
std::string table_of(const model::Robot& robot, const Plan& plan);

}  // namespace qvgen::calibrate
