// SPDX-License-Identifier: MIT
#include "batch_peers.h"

#include <memory>

#include "kdl.h"
#include "mujoco.h"
#include "reference/load.h"

namespace throughput {
namespace {

using comparison::KdlArm;
using comparison::MujocoArm;

std::string description_of(const std::string& robot) {
  return QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml";
}

/// Returns a call of the functions that both libraries have, for `n` joints.
template <class Library>
PeerCall dynamics(const std::string& function, const std::shared_ptr<Library>& arm, std::size_t n) {
  if (function == "inverse_dynamics")
    return [=](const double* in) { return arm->inverse_dynamics(in, in + n, in + 2 * n); };
  if (function == "forward_dynamics")
    return [=](const double* in) { return arm->forward_dynamics(in, in + n, in + 2 * n); };
  if (function == "mass_matrix") return [=](const double* in) { return arm->mass_matrix(in); };
  return nullptr;
}

PeerCall kdl(const std::string& robot, const std::string& function, std::size_t n) {
  const auto arm = std::make_shared<KdlArm>(description_of(robot));
  if (function == "forward_kinematics") return [=](const double* in) { return arm->forward_kinematics(in); };
  if (function == "jacobian") return [=](const double* in) { return arm->jacobian(in); };
  return dynamics(function, arm, n);
}

}  // namespace

std::vector<Peer> peers_of(const std::string& robot_and_function) {
  const std::size_t space = robot_and_function.find(' ');
  const std::string robot = robot_and_function.substr(0, space);
  const std::string function = robot_and_function.substr(space + 1);
  const auto chain = std::make_shared<reference::Chain>(reference::load(description_of(robot)));
  const std::size_t n = chain->joints.size();
  if (function == "inverse_dynamics_derivatives") return {};
  std::vector<Peer> peers{{"KDL", [=] { return kdl(robot, function, n); }}};
  if (dynamics(function, std::shared_ptr<MujocoArm>(), n))
    peers.push_back({"MuJoCo", [=] { return dynamics(function, std::make_shared<MujocoArm>(*chain), n); }});
  return peers;
}

}  // namespace throughput
