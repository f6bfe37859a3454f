// SPDX-License-Identifier: MIT
// Links of the plain recursion: those of a description, or of standard parameters, in numbers at a point.
#include <algorithm>
#include <cstdlib>

#include "derive/dynamics/drive_parameters.h"
#include "derive/dynamics/exact_vectors.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/plain_recursion.h"
#include "derive/dynamics/pseudo_inertia.h"
#include "derive/dynamics/rotation_sequence.h"
#include "model/coordinates.h"
#include "model/mechanism.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Number;

/// Rodrigues' formula, the matrix of the thesis's unit quaternion [cos(angle/2), sin(angle/2) axis] (1.3).
Matrix rotation(const Vector& axis, const exact::CosineSine& angle) {
  Matrix result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector e = identity()[k];
    result[k] =
        angle.cosine * e + angle.sine * cross(axis, e) + ((Number(1) - angle.cosine) * dot(axis, e)) * axis;
  }
  return transpose(result);
}

}  // namespace

PlainRecursion::PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point, const Move& move)
    : point_(point),
      shares_(model::shares(robot)),
      driven_(model::coordinates(robot)),
      base_motions_(model::base_motions(robot)) {
  base_ = frame_of(robot.base);
  if (robot.floating_base) {
    base_mass_ = number_of(robot.floating_base->mass);
    base_centre_ = vector_of(robot.floating_base->centre_of_mass);
    base_inertia_ = tensor_of(*robot.floating_base);
  }
  tool_ = vector_of(robot.tool.translation);
  for (const model::Joint& joint : robot.joints) {
    Link link;
    link.revolute = joint.type == model::JointType::revolute;
    link.variable = joint.variable;
    link.parent = model::parent_of(robot, links_.size());
    link.before = frame_of(joint.before);
    link.after = frame_of(joint.after);
    link.axis = vector_of(joint.axis);
    const bool moved = links_.size() == move.joint;
    link.motion = {identity(), {}};
    if (link.revolute) {
      const exact::CosineSine angle = turn({{{joint.variable, 1}}, 0});
      link.motion.rotation = rotation(link.axis, moved ? exact::then(angle, move.turn) : angle);
    } else {
      const Number length = point.symbol(joint.variable);
      link.motion.position = (moved ? length + move.length : length) * link.axis;
    }
    link.mass = number_of(joint.inertia.mass);
    link.rotor = number_of(joint.drive.rotor_inertia);
    link.viscous = number_of(joint.drive.viscous_friction);
    link.coulomb = number_of(joint.drive.coulomb_friction);
    // Coulomb friction of joints with several leaders is refused by the readers.
    const model::Share& share = shares_[links_.size()].front();
    const std::string& leader = driven_[base_motions_ + share.driven];
    link.direction = Number(cln::signum(share.ratio)) * point.symbol(direction_of(leader));
    link.centre = vector_of(joint.inertia.centre_of_mass);
    link.inertia = tensor_of(joint.inertia);
    links_.push_back(link);
  }
  for (const model::Joint& joint : model::driven_joints(robot)) drives_.push_back(drive_of(robot, joint));
}

PlainRecursion::Drive PlainRecursion::drive_of(const model::Robot& robot, const model::Joint& driven) const {
  const auto found = std::find_if(robot.motors.begin(), robot.motors.end(), [&](const model::Motor& motor) {
    return motor.variable == driven.variable;
  });
  if (found == robot.motors.end()) return {};
  return {found - robot.motors.begin(),
          number_of(driven.drive.rotor_inertia),
          number_of(driven.drive.viscous_friction),
          number_of(driven.drive.coulomb_friction),
          0,
          point_.symbol(direction_of(driven.variable))};
}

Number PlainRecursion::number_of(const model::Expression& expression) const {
  using Kind = model::Expression::Kind;
  const auto operand = [&](std::size_t i) { return number_of(expression.operands()[i]); };
  switch (expression.kind()) {
    case Kind::number:
      return Number(expression.number());
    case Kind::pi:
      return point_.symbol("pi");
    case Kind::symbol:
      return point_.symbol(expression.name());
    case Kind::negate:
      return -operand(0);
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::root:
      return point_.root(operand(0));
    case Kind::sine:
      return point_.sine(to_angle(expression.operands()[0]));
    case Kind::cosine:
      return point_.cosine(to_angle(expression.operands()[0]));
    default:
      break;
  }
  Number result = expression.kind() == Kind::sum ? 0 : 1;
  if (expression.kind() == Kind::power) {
    for (long i = 0; i < std::labs(expression.exponent()); ++i) result = result * operand(0);
    return expression.exponent() < 0 ? result.inverse() : result;
  }
  for (std::size_t i = 0; i < expression.operands().size(); ++i)
    result = expression.kind() == Kind::sum ? result + operand(i) : result * operand(i);
  return result;
}

Vector PlainRecursion::vector_of(const model::Vector3& v) const {
  return {number_of(v[0]), number_of(v[1]), number_of(v[2])};
}

PlainRecursion::Matrix PlainRecursion::tensor_of(const model::Inertia& inertia) const {
  std::array<Number, 6> i;
  for (std::size_t k = 0; k < 6; ++k) i[k] = number_of(inertia.inertia[k]);
  return {{{i[0], i[3], i[5]}, {i[3], i[1], i[4]}, {i[5], i[4], i[2]}}};
}

exact::CosineSine PlainRecursion::turn(const exact::Angle& angle) const {
  return {point_.cosine(angle), point_.sine(angle)};
}

PlainRecursion::Frame PlainRecursion::frame_of(const model::Displacement& displacement) const {
  Frame frame{identity(), vector_of(displacement.translation)};
  for (const model::Turn& each : displacement.turns)
    frame.rotation = frame.rotation * rotation(vector_of(each.axis), turn(to_angle(each.angle)));
  return frame;
}

void PlainRecursion::take_standard_parameters() {
  for (Drive& drive : drives_) drive.rotor = drive.viscous = drive.coulomb = 0;
  std::size_t body = 0;
  if (floats()) take_standard_parameters_of(body++, base_mass_, base_centre_, base_inertia_);
  for (Link& link : links_) {
    link.rotor = link.viscous = link.coulomb = 0;
    take_standard_parameters_of(body++, link.mass, link.centre, link.inertia);
  }
}

void PlainRecursion::take_standard_parameters_of(std::size_t body, Number& mass, Vector& centre,
                                                 Matrix& inertia) const {
  const auto value = [&](std::size_t k) { return point_.symbol(standard_parameter(10 * body + k)); };
  mass = value(0);
  centre = mass.inverse() * Vector{value(1), value(2), value(3)};
  inertia = {
      {{value(4), value(7), value(9)}, {value(7), value(5), value(8)}, {value(9), value(8), value(6)}}};
  // Steiner: about the centre of mass.
  for (std::size_t k = 0; k < 3; ++k)
    inertia[k] = inertia[k] + (-mass * dot(centre, centre)) * identity()[k] + (mass * centre[k]) * centre;
}

void PlainRecursion::take_drive_parameters() {
  const auto take = [&](std::size_t unit, auto& to) {
    const auto value = [&](DriveParameter kind) { return point_.symbol(drive_parameter(unit, kind)); };
    to.rotor = value(DriveParameter::rotor_inertia);
    to.viscous = value(DriveParameter::viscous_friction);
    to.coulomb = value(DriveParameter::coulomb_friction);
    to.offset = value(DriveParameter::offset);
  };
  for (std::size_t i = 0; i < links_.size(); ++i) {
    take(i, links_[i]);
    if (shares_[i].size() > 1) links_[i].coulomb = 0;
  }
  for (Drive& drive : drives_)
    if (drive.motor) take(links_.size() + *drive.motor, drive);
}

void PlainRecursion::remove_friction() {
  for (Link& link : links_) link.viscous = link.coulomb = 0;
  for (Drive& drive : drives_) drive.viscous = drive.coulomb = 0;
}

}  // namespace qvgen::derive::dynamics
