// SPDX-License-Identifier: MIT
#include "model/links.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "model/arithmetic.h"
#include "model/followers.h"

namespace qvgen::model {
namespace {

Vector3 scaled(const Expression& factor, const Vector3& v) {
  return {multiply(factor, v[0]), multiply(factor, v[1]), multiply(factor, v[2])};
}

Expression dot(const Vector3& a, const Vector3& b) {
  return add(add(multiply(a[0], b[0]), multiply(a[1], b[1])), multiply(a[2], b[2]));
}

/// x of the frame before a displacement as it is in the frame behind it.
Vector3 behind(const Displacement& displacement, const Vector3& x) {
  std::vector<Turn> back;
  for (auto turn = displacement.turns.rbegin(); turn != displacement.turns.rend(); ++turn)
    back.push_back({turn->axis, negate(turn->angle)});
  return rotate(back, subtract(x, displacement.translation));
}

/// The part of an offset that stands along the axis of the turning joint behind it.
Vector3 along_next(const Displacement& between, const Joint& next) {
  if (next.type == JointType::prismatic) return {};
  const Vector3 axis = rotate(between.turns, next.axis);
  return scaled(dot(between.translation, axis), axis);
}

/// From the frame of one joint, moved, to that of the next one, not moved.
Displacement between(const Robot& robot, std::size_t joint) {
  const Displacement& after = robot.joints[joint].after;
  return compose(after, joint + 1 < robot.joints.size() ? robot.joints[joint + 1].before : robot.tool);
}

class Links {
 public:
  explicit Links(const Robot& robot) : robot_(robot) {
    for (const Parameter& parameter : robot.geometry) taken_.insert(parameter.name);
    for (const Joint& joint : robot.joints) taken_.insert(joint.variable);
  }

  Expression symbol(const std::string& letters, std::size_t joint) {
    std::string name = letters + std::to_string(joint + 1);
    while (taken_.count(name) > 0) name += "_";
    taken_.insert(name);
    parameters_.push_back({name, std::nullopt});
    return Expression::symbol(name);
  }

  /// In the joint's frame.
  Vector3 beginning(std::size_t i) {
    const Joint& joint = robot_.joints[i];
    if (joint.type == JointType::prismatic) return scaled(negate(symbol("length", i)), joint.axis);
    const Displacement before = i == 0 ? compose(robot_.base, joint.before) : between(robot_, i - 1);
    return scaled(negate(dot(before.translation, rotate(before.turns, joint.axis))), joint.axis);
  }
  [[nodiscard]] Vector3 end(std::size_t i) const {
    const Displacement to_next = between(robot_, i);
    if (i + 1 == robot_.joints.size()) return to_next.translation;
    return subtract(to_next.translation, along_next(to_next, robot_.joints[i + 1]));
  }

  Inertia link(std::size_t i, MassPlace place) {
    Inertia inertia;
    inertia.mass = symbol("m", i);
    const Displacement& after = robot_.joints[i].after;
    if (place == MassPlace::end) {
      inertia.centre_of_mass = behind(after, end(i));
      return inertia;
    }
    const Vector3 sum = add(beginning(i), end(i));
    inertia.centre_of_mass = behind(after, scaled(Expression(cln::cl_RA(1) / 2), sum));
    inertia.inertia = {symbol("Ixx", i), symbol("Iyy", i), symbol("Izz", i)};
    return inertia;
  }

  [[nodiscard]] std::vector<Parameter> parameters() const { return parameters_; }

 private:
  const Robot& robot_;
  std::set<std::string> taken_;
  std::vector<Parameter> parameters_;
};

}  // namespace

Robot first_joints(const Robot& robot, std::size_t count) {
  if (has_followers(robot))
    throw std::domain_error("a joint follows another: no part of the arm stands alone");
  if (count == 0 || count > robot.joints.size())
    throw std::domain_error(robot.name + " has " + std::to_string(robot.joints.size()) + " joints");
  Robot part = robot;
  if (count == robot.joints.size()) return part;
  part.joints.resize(count);
  part.tool = {};
  std::erase_if(part.frames, [&](const Frame& frame) { return frame.joint >= count; });
  part.inverse = {};
  const std::vector<std::string> used = symbols(part);
  std::erase_if(part.geometry, [&](const Parameter& parameter) {
    return std::find(used.begin(), used.end(), parameter.name) == used.end();
  });
  return part;
}

Robot with_masses(const Robot& robot, MassPlace place) {
  Robot result = robot;
  Links links(robot);
  for (std::size_t i = 0; i < result.joints.size(); ++i) {
    result.joints[i].inertia = links.link(i, place);
    result.joints[i].drive = {};
  }
  result.inertia_parameters = links.parameters();
  return result;
}

}  // namespace qvgen::model
