// SPDX-License-Identifier: MIT
// Calibration of an arm from measurements: which errors can be told at all, which these data tell, and their
// values.
//
// The errors of a gap are first reduced to a minimal complete set: those that move the tool's pose in the
// world differently, 4 for a turn and 2 for a slide and 6 (Everett and others 1987), by exact rank. Then to
// those that the kind of data can tell, by exact rank again, then to those that the data at hand tell, by
// numeric rank.
#pragma once

#include <Eigen/Core>

#include "calibrate/fit.h"

namespace qvgen::calibrate {

struct Options {
  Errors errors = Errors::all;
  bool eccentric = false;
  bool tracker_known = false, target_known = false;
  bool bending = false;
};

/// Parameters of an arm for a kind of data, and what of them can never be told.
struct Identifiable {
  Setup setup;
  Model<double> model;                  ///< the minimal complete set, and frames and surfaces
  std::vector<std::size_t> candidates;  ///< indices that this kind of data can tell, in the order of priority
  std::vector<std::string> never;       ///< in words
  std::vector<Dependence> dependent;    ///< parameters of the model that are never told
};

Setup setup_of(const DataSet& set, const Options& options);
Identifiable identifiable(const model::Robot& robot, const Setup& setup);

struct Outlier {
  int line;
  double size;  ///< standard deviations
};

struct Calibration {
  Identifiable identifiable;
  State state;
  State nominal;                    ///< frames and surfaces fitted to the arm as described
  std::vector<std::size_t> active;  ///< indices of parameters that were found, sorted
  Eigen::MatrixXd covariance;       ///< of the active ones
  std::vector<std::string> untold;  ///< by these data, in words
  std::vector<Dependence> dependent;
  std::vector<Outlier> outliers;
  std::vector<double> weights;
  Size before, after;                 ///< with frames and surfaces fitted in both
  double sigma = 0, sigma_angle = 0;  ///< the deviations that weighed: said, or found from the residuals
  double freedom = 1;                 ///< numbers measured beyond the unknowns
  double misfit = 1;  ///< root mean square of residuals over their deviations, by the degrees of freedom
  /// Residuals of every fifth measurement, with a fit of the others; and as the covariance promises.
  std::optional<Size> hold_out, expected;
};

/// Why data cannot be used: too few rows, or an arm that they do not fit at all.
struct DataError {
  std::string message, hint;
};

/// Calibrates; or says why not.
std::optional<Calibration> calibrate(const model::Robot& robot, DataSet set, const Options& options,
                                     DataError& error);

}  // namespace qvgen::calibrate
