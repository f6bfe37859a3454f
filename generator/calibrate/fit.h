// SPDX-License-Identifier: MIT
// Least squares by Levenberg and Marquardt, with outliers found and left out. The normal equations are summed
// up row by row, so memory does not grow with the data; some forty unknowns need no library beyond Eigen.
#pragma once

#include <Eigen/Core>

#include "calibrate/residual.h"

namespace qvgen::calibrate {

/// Measurements with a weight each: 0 leaves one out.
struct Weighted {
  const DataSet* set = nullptr;
  std::vector<double> weights;
};

/// Normal equations J^T W J x = -J^T W r of the active parameters, whitened by the deviations.
struct Normal {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;
  double cost = 0;     ///< sum of squares
  double numbers = 0;  ///< how many entries of residuals have a weight
};
Normal normal_of(const Model<double>& model, const Weighted& data, const State& state,
                 const std::vector<std::size_t>& active);

/// Returns the state of least squares next to `state`; at most `most` steps.
State fit(const Model<double>& model, const Weighted& data, State state,
          const std::vector<std::size_t>& active, int most = 60);

/// Fits with outliers left out: weights fall with the residual at first, then are 1 or 0.
struct RobustFit {
  State state;
  std::vector<double> weights;
};
RobustFit robust_fit(const Model<double>& model, const DataSet& set, const State& start,
                     const std::vector<std::size_t>& active, std::vector<double> weights);

/// Returns the size of each measurement's residual in standard deviations: 1 is usual.
std::vector<double> sizes_of(const Model<double>& model, const DataSet& set, const State& state);

/// Root mean squares of residuals (m and rad) over measurements with a weight.
struct Size {
  double position = 0, angle = 0;
  double greatest_position = 0;
};
Size size_of(const Model<double>& model, const Weighted& data, const State& state);

/// Returns which parameters the data at hand tell, keeping them in the order of priority. A parameter whose
/// deviation would be more than `most_length` or `most_angle` beside those before it is not told.
inline constexpr double most_length = 0.01, most_angle = 0.02;
Rank numeric_rank(const Model<double>& model, const Weighted& data, const State& state,
                  const std::vector<std::size_t>& candidates);

}  // namespace qvgen::calibrate
