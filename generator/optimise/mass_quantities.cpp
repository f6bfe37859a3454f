// SPDX-License-Identifier: MIT
#include "model/followers.h"
#include "optimise/dynamics.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::PlainRecursion;
using exact::ExactPoint;
using exact::Number;
using Values = std::vector<Number>;

Values centre_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  const auto expected = plain.centre_of_mass();
  Values rest;
  for (std::size_t i = 0; i < 3; ++i) rest.push_back(values.at(i) - expected[i]);
  return rest;
}

/// The centre of mass is linear in the sine and cosine of each joint of the chain, and in the length of a
/// slide: its derivative is half of the difference of two places, a quarter turn or one metre to each side.
PlainRecursion::Vector centre_derivative(const model::Robot& robot, const ExactPoint& point,
                                         std::size_t joint) {
  const bool turns = robot.joints[joint].type == model::JointType::revolute;
  const auto moved = [&](long sign) {
    const PlainRecursion::Move turn{joint, {0, sign}, 0}, slide{joint, {}, sign};
    return PlainRecursion(robot, point, turns ? turn : slide).centre_of_mass();
  };
  const auto up = moved(1), down = moved(-1);
  PlainRecursion::Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = (up[i] - down[i]) / Number(2);
  return result;
}

/// Followers move with their leaders, by their ratios.
Values jacobian_residuals(const model::Robot& robot, const ExactPoint& point, const Values& values) {
  Values rest = values;
  const std::vector<std::vector<model::Share>> shares = model::shares(robot);
  for (std::size_t joint = 0; joint < shares.size(); ++joint) {
    const auto column = centre_derivative(robot, point, joint);
    for (const model::Share& share : shares[joint])
      for (std::size_t i = 0; i < 3; ++i) {
        Number& entry = rest.at(3 * share.driven + i);
        entry = entry - Number(share.ratio) * column[i];
      }
  }
  return rest;
}

}  // namespace

std::vector<DynamicsQuantity> mass_quantities(const model::Robot& described) {
  return {{"centre_of_mass", derive::dynamics::centre_of_mass, centre_residuals},
          {"centre_of_mass_jacobian", derive::dynamics::centre_of_mass_jacobian,
           [described](const PlainRecursion&, const ExactPoint& point, const Values& values) {
             return jacobian_residuals(described, point, values);
           }}};
}

}  // namespace qvgen::optimise
