// SPDX-License-Identifier: MIT
#include "identify/divergence.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// An orthonormal basis of symmetric matrices.
const std::array<PseudoInertia, 10>& symmetric_basis() {
  static const auto all = [] {
    std::array<PseudoInertia, 10> result;
    std::size_t k = 0;
    for (Index a = 0; a < 4; ++a)
      for (Index b = a; b < 4; ++b, ++k) {
        result[k].setZero();
        result[k](a, b) = result[k](b, a) = a == b ? 1 : std::sqrt(0.5);
      }
    return result;
  }();
  return all;
}

PseudoInertia link_of(const VectorXd& values, Index link) {
  return pseudo_inertia(values.segment<10>(10 * link));
}

/// Logarithm of the determinant; minus infinity if the matrix is not positive definite.
double log_determinant(const PseudoInertia& matrix) {
  const Eigen::LLT<PseudoInertia> factor(matrix);
  const Eigen::Vector4d diagonal = factor.matrixLLT().diagonal();
  if (factor.info() != Eigen::Success || !(diagonal.minCoeff() > 0)) return -infinite;
  return 2 * diagonal.array().log().sum();
}

}  // namespace

PseudoInertia pseudo_inertia(const Standard& p) {
  const double half_trace = (p[4] + p[5] + p[6]) / 2;
  PseudoInertia result;
  result << half_trace - p[4], -p[7], -p[9], p[1],  //
      -p[7], half_trace - p[5], -p[8], p[2],        //
      -p[9], -p[8], half_trace - p[6], p[3],        //
      p[1], p[2], p[3], p[0];
  return result;
}

Standard standard_of(const PseudoInertia& p) {
  Standard result;
  result << p(3, 3), p(0, 3), p(1, 3), p(2, 3), p(1, 1) + p(2, 2), p(0, 0) + p(2, 2), p(0, 0) + p(1, 1),
      -p(0, 1), -p(1, 2), -p(0, 2);
  return result;
}

Divergence::Divergence(const Prior& prior) : prior_(prior) {
  for (const PseudoInertia& link : prior.links) {
    if (!std::isfinite(log_determinant(link)))
      throw std::runtime_error("a link of the prior is no body: its mass or its moments are not positive");
    inverse_.push_back(link.inverse());
  }
  if (!(prior.drives.minCoeff() > 0)) throw std::runtime_error("a drive of the prior is not above zero");
}

VectorXd Divergence::prior() const {
  VectorXd values(10 * links() + drives());
  for (Index i = 0; i < links(); ++i)
    values.segment<10>(10 * i) = standard_of(prior_.links[static_cast<std::size_t>(i)]);
  values.tail(drives()) = prior_.drives;
  for (Index k = 3; k < drives(); k += 4) values[10 * links() + k] = 0;
  return values;
}

double Divergence::at(const VectorXd& values) const {
  double sum = 0;
  for (Index i = 0; i < links(); ++i) {
    const auto& inverse = inverse_[static_cast<std::size_t>(i)];
    const PseudoInertia link = link_of(values, i);
    sum += (inverse * link).trace() - log_determinant(link) - log_determinant(inverse) - 4;
  }
  for (Index k = 0; k < drives(); ++k) {
    const double share = values[10 * links() + k] / prior_.drives[k];
    if (has_sign(k) && !(share > 0)) return infinite;
    sum += has_sign(k) ? share - std::log(share) - 1 : share * share / 2;
  }
  return sum;
}

MatrixXd Divergence::directions(const VectorXd& values) const {
  MatrixXd result = MatrixXd::Zero(values.size(), values.size());
  for (Index i = 0; i < links(); ++i) {
    const PseudoInertia factor = Eigen::LLT<PseudoInertia>(link_of(values, i)).matrixL();
    for (Index k = 0; k < 10; ++k)
      result.block<10, 1>(10 * i, 10 * i + k) =
          standard_of(factor * symmetric_basis()[static_cast<std::size_t>(k)] * factor.transpose());
  }
  for (Index k = 0; k < drives(); ++k) {
    const Index place = 10 * links() + k;
    result(place, place) = has_sign(k) ? values[place] : prior_.drives[k];
  }
  return result;
}

VectorXd Divergence::slope(const VectorXd& values) const {
  VectorXd result(values.size());
  for (Index i = 0; i < links(); ++i) {
    const PseudoInertia factor = Eigen::LLT<PseudoInertia>(link_of(values, i)).matrixL();
    const PseudoInertia difference =
        factor.transpose() * inverse_[static_cast<std::size_t>(i)] * factor - PseudoInertia::Identity();
    for (Index k = 0; k < 10; ++k)
      result[10 * i + k] = difference.cwiseProduct(symmetric_basis()[static_cast<std::size_t>(k)]).sum();
  }
  for (Index k = 0; k < drives(); ++k) {
    const double share = values[10 * links() + k] / prior_.drives[k];
    result[10 * links() + k] = has_sign(k) ? share - 1 : share;
  }
  return result;
}

}  // namespace qvgen::identify
