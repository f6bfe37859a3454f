// SPDX-License-Identifier: MIT
#include "verify/loops/singular_values.h"

#include <Eigen/SVD>

namespace qvgen::verify {

using Decomposition = Eigen::JacobiSVD<Eigen::MatrixXd>;

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return Decomposition(matrix).singularValues();
}

SingularMotions singular_motions(const Eigen::MatrixXd& matrix) {
  const Decomposition decomposition(matrix, Eigen::ComputeFullV);
  return {decomposition.singularValues(), decomposition.matrixV()};
}

}  // namespace qvgen::verify
