// SPDX-License-Identifier: MIT
// Representatives of solutions within limits by C++, compiled for three numbers of joints. Compiled for each
// robot they would take longer than all of its C.
#include <algorithm>
#include <array>

#include <qvgen/inverse/joint_limits.h>

#include "robot_in_c.h"

namespace qvgen::test {
namespace {

constexpr int capacity = 16;  // of the committed robots with most rows

/// Arms of fewer than `dof` joints have slides behind them that stay at zero.
template <int dof>
std::vector<Row> within(const std::vector<Row>& rows, const Eigen::VectorXd& lower,
                        const Eigen::VectorXd& upper, const bool* is_revolute) {
  const Eigen::Index count = lower.size();
  const auto padded = [&](const Eigen::VectorXd& values) {
    Joints<dof> all = Joints<dof>::Zero();
    std::copy_n(values.data(), count, all.data());
    return all;
  };
  Solutions<dof, capacity> found;
  for (const Row& row : rows) inverse::append(found, padded(row.q), row.branch, row.continuum);
  std::array<bool, dof> revolute{};
  std::copy_n(is_revolute, count, revolute.begin());
  std::vector<Row> all;
  for (const auto& row : within_limits(found, JointLimits<dof>{padded(lower), padded(upper)}, revolute))
    all.push_back(row_of(row.q.data(), static_cast<int>(count), row.branch, row.continuum ? 1 : 0));
  return all;
}

}  // namespace

std::vector<Row> representatives_in_cxx(const std::vector<Row>& rows, const Eigen::VectorXd& lower,
                                        const Eigen::VectorXd& upper, const bool* is_revolute) {
  const auto of_dof = lower.size() > 6 ? within<7> : lower.size() > 3 ? within<6> : within<3>;
  return of_dof(rows, lower, upper, is_revolute);
}

}  // namespace qvgen::test
