// SPDX-License-Identifier: MIT
#include "identify/payload.h"

#include <cmath>

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns of the arm and then ten of the payload, which act in the second equations alone.
Equations joined(const ArmRegressor& arm, const Equations& without, const Equations& with) {
  const Index n = arm.parameters(), last = static_cast<Index>(10 * (arm.links - 1));
  Equations all;
  for (std::size_t i = 0; i < without.size(); ++i) {
    const std::vector<Index>& own = without[i].columns();
    const auto count = static_cast<Index>(own.size());
    std::vector<Index> columns = own;
    for (Index k = 0; k < standard_count; ++k) columns.push_back(n + k);
    MatrixXd payload(count, standard_count);
    for (Index k = 0; k < count; ++k)
      payload.row(k) = arm.combination.block(own[static_cast<std::size_t>(k)], last, 1, standard_count);
    JointEquations equations(columns);
    for (const JointEquations* part : {&without[i], &with[i]}) {
      const MatrixXd triangle = part->triangle();
      equations.add(triangle.rows(), [&](auto rows) {
        rows.setZero();
        rows.leftCols(count) = triangle.leftCols(count);
        if (part == &with[i]) rows.middleCols(count, standard_count) = triangle.leftCols(count) * payload;
        rows.col(rows.cols() - 1) = triangle.col(count);
      });
      equations.count(part->measured());
    }
    all.push_back(std::move(equations));
  }
  return all;
}

/// Mass, centre, inertia about the centre, as ten numbers.
VectorXd body_of(const Standard& p) {
  VectorXd body(10);
  const double mass = p[0];
  const Eigen::Vector3d c = p.segment<3>(1) / mass;
  body << mass, c, p[4] - mass * (c[1] * c[1] + c[2] * c[2]), p[5] - mass * (c[0] * c[0] + c[2] * c[2]),
      p[6] - mass * (c[0] * c[0] + c[1] * c[1]), p[7] + mass * c[0] * c[1], p[8] + mass * c[1] * c[2],
      p[9] + mass * c[0] * c[2];
  return body;
}

/// Derivatives by differences; the function is smooth, and deviations need no more digits.
MatrixXd derivative_of(const Standard& p) {
  MatrixXd result(10, 10);
  for (Index k = 0; k < 10; ++k) {
    const double step = 1e-6 * std::max(1e-3, p.cwiseAbs().maxCoeff());
    result.col(k) =
        (body_of(p + step * Standard::Unit(k)) - body_of(p - step * Standard::Unit(k))) / (2 * step);
  }
  return result;
}

Payload payload(const VectorXd& body) {
  Payload result{body[0], body.segment<3>(1), {}};
  for (Index k = 0; k < 6; ++k) result.inertia[static_cast<std::size_t>(k)] = body[4 + k];
  return result;
}

}  // namespace

PayloadEstimate payload_of(const ArmRegressor& arm, const Equations& without, const Equations& with) {
  const Index n = arm.parameters();
  const Estimate found = estimate(joined(arm, without, with), n + standard_count);
  PayloadEstimate result;
  result.parameters = found.value.tail<10>();
  for (Index k = 0; k < standard_count; ++k)
    result.told[static_cast<std::size_t>(k)] = found.told[static_cast<std::size_t>(n + k)];
  result.body = payload(body_of(result.parameters));
  const MatrixXd turn = derivative_of(result.parameters);
  const MatrixXd covariance = turn * found.covariance.bottomRightCorner(10, 10) * turn.transpose();
  result.deviation = payload(covariance.diagonal().cwiseMax(0).cwiseSqrt());
  result.condition = found.condition;
  return result;
}

}  // namespace qvgen::identify
