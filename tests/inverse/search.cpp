// SPDX-License-Identifier: MIT
#include "search.h"

#include <algorithm>

#include "reference/linear_algebra.h"

namespace qvgen::test {

bool descend(const Case& test, Eigen::VectorXd& q, const Eigen::Isometry3d& target) {
  double damping = 1e-2;
  Eigen::VectorXd r = test.residual(q, target);
  for (int step = 0; step < 200 && r.norm() > 1e-16; ++step) {
    const Eigen::MatrixXd jacobian = test.jacobian(q);
    Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd next = test.moved(q, reference::solve_symmetric(normal, jacobian.transpose() * r));
    const Eigen::VectorXd next_residual = test.residual(next, target);
    const bool better = next_residual.norm() < r.norm();
    if (!better && r.norm() < 1e-13) break;
    damping = better ? damping / 5 : damping * 4;
    if (better) {
      q = next;
      r = next_residual;
    }
  }
  return r.norm() <= 1e-11;
}

bool nearly_singular(const Case& test, const Eigen::VectorXd& q) {
  return reference::smallest_singular_value(test.jacobian(q)) < 1e-3;
}

std::vector<Eigen::VectorXd> search(const Case& test, const Sample& sample, std::size_t returned,
                                    const std::function<Eigen::VectorXd()>& start) {
  constexpr int at_least = 60;
  constexpr int at_most = 4000;
  std::vector<Eigen::VectorXd> ends;
  for (int i = 0; i < at_most && (i < at_least || ends.size() < returned); ++i) {
    Eigen::VectorXd q = start();
    if (!descend(test, q, sample.target)) continue;
    const bool known =
        std::any_of(ends.begin(), ends.end(), [&](const auto& end) { return test.distance(end, q) < 1e-5; });
    if (!known) ends.push_back(q);
  }
  return ends;
}

}  // namespace qvgen::test
