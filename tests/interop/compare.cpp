// SPDX-License-Identifier: MIT
#include "compare.h"

#include <gtest/gtest.h>

#include "description/write.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace arms {
namespace {

void expect_near(const MatrixXd& a, const MatrixXd& b, double tolerance, const char* what) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff()), tolerance) << what;
}

qvgen::model::Robot checked(const qvgen::description::ReadResult& result) {
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity != qvgen::description::Diagnostic::note) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value();
}

}  // namespace

qvgen::model::Robot read(const std::string& text, const std::string& file,
                         qvgen::description::SnapOptions::Mode snap) {
  qvgen::description::ReadOptions options;
  options.snap.mode = snap;
  options.tip = "tool0";
  return checked(qvgen::description::read_text(text, file, options));
}

qvgen::model::Robot read_file(const std::filesystem::path& file, const std::string& tip) {
  qvgen::description::ReadOptions options;
  options.snap.mode = qvgen::description::SnapOptions::off;
  options.tip = tip;
  return checked(qvgen::description::read_file(file, options));
}

reference::Chain chain_of(const qvgen::model::Robot& robot) {
  return reference::load_text(qvgen::description::write_text(robot));
}

void compare(const reference::Chain& chain, Peer& peer, std::mt19937& random, double tolerance,
             bool forward_dynamics) {
  std::uniform_real_distribution<double> any(-2, 2);
  const auto vector = [&] { return VectorXd::NullaryExpr(chain.size(), [&] { return any(random); }).eval(); };
  for (int i = 0; i < 3; ++i) {
    const VectorXd q = vector(), qd = vector(), qdd = vector();
    expect_near(reference::forward_kinematics(chain, q).matrix(), peer.tool(q).matrix(), tolerance, "pose");
    expect_near(reference::jacobian(chain, q), peer.jacobian(q), tolerance, "Jacobian");
    const VectorXd torque = peer.inverse_dynamics(q, qd, qdd);
    expect_near(reference::inverse_dynamics(chain, q, qd, qdd), torque, tolerance, "inverse dynamics");
    if (!forward_dynamics) continue;
    expect_near(reference::forward_dynamics(chain, q, qd, torque), peer.forward_dynamics(q, qd, torque),
                tolerance, "forward dynamics");
  }
}

}  // namespace arms
