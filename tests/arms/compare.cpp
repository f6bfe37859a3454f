// SPDX-License-Identifier: MIT
#include "compare.h"

#include <gtest/gtest.h>

#include "description/write.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace arms {
namespace {

void expect_near(const MatrixXd& a, const MatrixXd& b, const char* what) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff()), 1e-12) << what;
}

}  // namespace

qvgen::model::Robot read(const std::string& text, const std::string& file,
                         qvgen::description::SnapOptions::Mode snap) {
  qvgen::description::ReadOptions options;
  options.snap.mode = snap;
  options.tip = "tool0";
  const auto result = qvgen::description::read_text(text, file, options);
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity != qvgen::description::Diagnostic::note) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value();
}

reference::Chain chain_of(const qvgen::model::Robot& robot) {
  return reference::load_text(qvgen::description::write_text(robot));
}

void compare(const reference::Chain& chain, Peer& peer, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-2, 2);
  const auto vector = [&] { return VectorXd::NullaryExpr(chain.size(), [&] { return any(random); }).eval(); };
  for (int i = 0; i < 3; ++i) {
    const VectorXd q = vector(), qd = vector(), qdd = vector();
    expect_near(reference::forward_kinematics(chain, q).matrix(), peer.tool(q).matrix(), "pose");
    expect_near(reference::jacobian(chain, q), peer.jacobian(q), "Jacobian");
    const VectorXd torque = peer.inverse_dynamics(q, qd, qdd);
    expect_near(reference::inverse_dynamics(chain, q, qd, qdd), torque, "inverse dynamics");
    expect_near(reference::forward_dynamics(chain, q, qd, torque), peer.forward_dynamics(q, qd, torque),
                "forward dynamics");
  }
}

}  // namespace arms
