// SPDX-License-Identifier: MIT
// Singular values of matrices of any size, compiled once for all files that ask for ranks and motions of
// mechanisms.
#pragma once

#include <Eigen/Core>

namespace qvgen::verify {

/// Returns the singular values of a matrix, which has rows, the greatest first.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

struct SingularMotions {
  Eigen::VectorXd values;  ///< the greatest first; none without rows
  Eigen::MatrixXd
      motions;  ///< orthonormal columns in the order of the values, then those that the matrix maps to zero
};

/// Returns the decomposition of a matrix with a column for each joint.
SingularMotions singular_motions(const Eigen::MatrixXd& matrix);

}  // namespace qvgen::verify
