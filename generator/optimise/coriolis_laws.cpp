// SPDX-License-Identifier: MIT
#include "optimise/coriolis_laws.h"

#include "derive/dynamics/plain_recursion.h"
#include "model/coordinates.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::PlainRecursion;
using exact::Number;
using Values = std::vector<Number>;

/// The derivative of the kinetic energy of given velocities by a joint of the chain: along a slide it is a
/// polynomial of degree two, along a turn a trigonometric one, so that differences are exact
/// (dynamics_derivatives.h).
Number kinetic_energy_by_joint(const model::Robot& robot, const exact::ExactPoint& point, std::size_t joint,
                               const Values& velocities) {
  const auto energy = [&](const PlainRecursion::Move& move) {
    return PlainRecursion(robot, point, move).kinetic_energy(velocities);
  };
  const auto odd = [&](const PlainRecursion::Move& up, const PlainRecursion::Move& down) {
    return (energy(up) - energy(down)) / Number(2);
  };
  if (robot.joints[joint].type == model::JointType::prismatic) return odd({joint, {}, 1}, {joint, {}, -1});
  const Number sine = Number(4) / Number(5), cosine = Number(3) / Number(5);
  const Number small = odd({joint, {cosine, sine}, 0}, {joint, {cosine, -sine}, 0});
  const Number right = odd({joint, {0, 1}, 0}, {joint, {0, -1}, 0});
  return Number(25) / Number(12) * small + Number(-2) / Number(3) * right;
}

/// While the joints move at their rates at the point.
Number kinetic_energy_rate(const model::Robot& robot, const exact::ExactPoint& point, const Values& rates,
                           const Values& velocities) {
  const std::vector<std::vector<model::Share>> shares = model::shares(robot);
  Number sum = 0;
  for (std::size_t joint = 0; joint < shares.size(); ++joint) {
    Number rate = 0;
    for (const model::Share& share : shares[joint])
      rate = rate + Number(share.ratio) * rates[model::base_motions(robot) + share.driven];
    sum = sum + rate * kinetic_energy_by_joint(robot, point, joint, velocities);
  }
  return sum;
}

}  // namespace

Values residuals_of_coriolis_laws(const model::Robot& robot, const exact::ExactPoint& point,
                                  const Values& values) {
  PlainRecursion plain(robot, point);
  plain.remove_friction();
  const std::size_t n = plain.size();
  const Values v = plain.rates(), u = plain.accelerations();
  Values rest = plain.inverse_dynamics(v, Values(n), 0);
  Number form = Number(-1) * kinetic_energy_rate(robot, point, v, u);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      rest[i] = rest[i] - values.at(i * n + k) * v[k];
      form = form + u[i] * values.at(i * n + k) * u[k];
    }
  rest.push_back(form);
  return rest;
}

}  // namespace qvgen::optimise
