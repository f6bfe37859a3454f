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

const std::array<PseudoInertia, 10>& directions() {
  static const auto all = [] {
    std::array<PseudoInertia, 10> result;
    for (std::size_t k = 0; k < 10; ++k) result[k] = pseudo_inertia(Standard::Unit(static_cast<Index>(k)));
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
  VectorXd values(14 * links());
  for (Index i = 0; i < links(); ++i)
    values.segment<10>(10 * i) = standard_of(prior_.links[static_cast<std::size_t>(i)]);
  values.tail(4 * links()) = prior_.drives;
  for (Index k = 3; k < 4 * links(); k += 4) values[10 * links() + k] = 0;
  return values;
}

double Divergence::at(const VectorXd& values) const {
  double sum = 0;
  for (Index i = 0; i < links(); ++i) {
    const auto& inverse = inverse_[static_cast<std::size_t>(i)];
    const PseudoInertia link = link_of(values, i);
    sum += (inverse * link).trace() - log_determinant(link) - log_determinant(inverse) - 4;
  }
  for (Index k = 0; k < 4 * links(); ++k) {
    const double share = values[10 * links() + k] / prior_.drives[k];
    if (has_sign(k) && !(share > 0)) return infinite;
    sum += has_sign(k) ? share - std::log(share) - 1 : share * share / 2;
  }
  return sum;
}

VectorXd Divergence::gradient(const VectorXd& values) const {
  VectorXd result(values.size());
  for (Index i = 0; i < links(); ++i) {
    const PseudoInertia difference = inverse_[static_cast<std::size_t>(i)] - link_of(values, i).inverse();
    for (Index k = 0; k < 10; ++k)
      result[10 * i + k] = difference.cwiseProduct(directions()[static_cast<std::size_t>(k)]).sum();
  }
  for (Index k = 0; k < 4 * links(); ++k) {
    const double value = values[10 * links() + k], prior = prior_.drives[k];
    result[10 * links() + k] = has_sign(k) ? 1 / prior - 1 / value : value / (prior * prior);
  }
  return result;
}

MatrixXd Divergence::hessian(const VectorXd& values) const {
  MatrixXd result = MatrixXd::Zero(values.size(), values.size());
  for (Index i = 0; i < links(); ++i) {
    const PseudoInertia inverse = link_of(values, i).inverse();
    for (Index k = 0; k < 10; ++k) {
      const PseudoInertia moved = inverse * directions()[static_cast<std::size_t>(k)] * inverse;
      for (Index l = 0; l < 10; ++l)
        result(10 * i + k, 10 * i + l) = moved.cwiseProduct(directions()[static_cast<std::size_t>(l)]).sum();
    }
  }
  for (Index k = 0; k < 4 * links(); ++k) {
    const Index place = 10 * links() + k;
    const double size = has_sign(k) ? values[place] : prior_.drives[k];
    result(place, place) = 1 / (size * size);
  }
  return result;
}

}  // namespace qvgen::identify
