// SPDX-License-Identifier: MIT
// Completeness: a numerical search from random starts, which knows nothing of branches, must find no solution that
// the generated code lacks.
#include "check.h"

namespace qvgen::test {
namespace {

class InverseSearch : public Inverse {};

/// Levenberg-Marquardt; true if it ends on the pose.
bool descend(const Case& test, Eigen::VectorXd& q, const Eigen::Isometry3d& target) {
  double damping = 1e-2;
  Eigen::VectorXd r = test.residual(q, target);
  for (int step = 0; step < 80 && r.norm() > 1e-11; ++step) {
    const Eigen::MatrixXd jacobian = test.jacobian(q);
    Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd next = test.moved(q, normal.ldlt().solve(jacobian.transpose() * r));
    const Eigen::VectorXd next_residual = test.residual(next, target);
    const bool better = next_residual.norm() < r.norm();
    damping = better ? damping / 5 : damping * 4;
    if (better) {
      q = next;
      r = next_residual;
    }
  }
  return r.norm() <= 1e-11;
}

TEST_P(InverseSearch, FindsNothingNew) {
  constexpr int poses = 4;
  constexpr int starts = 40;
  int ends = 0;
  for (int i = 0; i < poses; ++i) {
    const Eigen::VectorXd sampled = test().joints();
    const Eigen::Isometry3d target = test().tool(sampled);
    const Found found = test().solve(sampled);
    for (int k = 0; k < starts; ++k) {
      Eigen::VectorXd q = test().joints();
      if (GetParam().info.given_joint >= 0) q[GetParam().info.given_joint] = test().given(sampled);
      if (!descend(test(), q, target)) continue;
      ++ends;
      EXPECT_TRUE(contains(test(), found, sample_at(test(), q))) << GetParam().name << " lacks " << q.transpose();
    }
  }
  EXPECT_GT(ends, poses) << "the search itself found nothing";
}

std::string name_of(const testing::TestParamInfo<InverseUnderTest>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Robots, InverseSearch, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
