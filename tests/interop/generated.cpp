// SPDX-License-Identifier: MIT
#include "generated.h"

#include <algorithm>
#include <random>

#include "arm.h"

namespace arms {
namespace {

void expect_near(const MatrixXd& a, const MatrixXd& b, const char* what) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff()), 1e-12) << what;
}

}  // namespace

void compare_generated(Peer&& generated, const std::string& name, const std::string& format) {
  const auto table = read_table(QVGEN_SOURCE_DIR "/tests/interop/arms.txt");
  const auto arm = std::find_if(table.begin(), table.end(), [&](const Arm& a) { return a.name == name; });
  ASSERT_NE(arm, table.end());
  const auto peer = format == "urdf" ? kdl(urdf(*arm)) : mujoco(mjcf(*arm));
  const double friction = format == "urdf" ? 0.3 : 0;  // KDL knows none
  const auto size = static_cast<Eigen::Index>(arm->joints.size());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-2, 2);
  const auto vector = [&] { return VectorXd::NullaryExpr(size, [&] { return any(random); }).eval(); };
  for (int i = 0; i < 100; ++i) {
    const VectorXd q = vector(), qd = vector(), qdd = vector();
    expect_near(generated.tool(q).matrix(), peer->tool(q).matrix(), "pose");
    expect_near(generated.jacobian(q), peer->jacobian(q), "Jacobian");
    const VectorXd torque = peer->inverse_dynamics(q, qd, qdd) + friction * qd;
    expect_near(generated.inverse_dynamics(q, qd, qdd), torque, "inverse dynamics");
    expect_near(generated.forward_dynamics(q, qd, torque),
                peer->forward_dynamics(q, qd, torque - friction * qd), "forward dynamics");
  }
}

}  // namespace arms
