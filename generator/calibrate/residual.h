// SPDX-License-Identifier: MIT
// Differences between what was measured and what a state of the parameters predicts, with their derivatives.
#pragma once

#include <Eigen/Core>

#include "calibrate/data.h"
#include "calibrate/observe.h"

namespace qvgen::calibrate {

/// Values of all parameters. Those of frames and surfaces are moved into these, and are zero themselves.
struct State {
  std::vector<double> values;
  Frames<double> frames;
  std::vector<Surface<double>> surfaces;
};

struct Residual {
  Eigen::VectorXd value;       ///< m and rad, predicted minus measured; rows as in observe.h
  Eigen::MatrixXd derivative;  ///< by all parameters
};

/// Returns the residual of one measurement. `derivative` is left empty if it is not wanted.
Residual residual_of(const Model<double>& model, Data data, const State& state, const Measurement& measured,
                     bool derivative = true);

/// Returns the standard deviation of each entry of a residual.
Eigen::VectorXd deviations(Data data, const Measurement& measured);

/// Adds a step to a state; steps of frames and surfaces move them.
State moved(const Model<double>& model, State state, const Eigen::VectorXd& step,
            const std::vector<std::size_t>& active);

/// Returns the rotation vector of R (rad).
Vec<double> rotation_vector(const Rigid<double>& m);

}  // namespace qvgen::calibrate
