// SPDX-License-Identifier: MIT
#include "swivel.h"

#include <cmath>

#include <qvgen/inverse/requested_pose.h>

namespace qvgen::inverse::arm_angle {

namespace {

/// Below this a sine is what rounding leaves.
constexpr double no_direction = 1e-13;

bool is_zero(const Vector3<double>& v) { return v.squaredNorm() == 0; }

/// The first axis's direction away from the base; its own where the base does not tell.
Vector3<double> upwards(const Arm& arm) {
  return (arm.shoulder - arm.base).dot(arm.axes[0]) < 0 ? Vector3<double>(-arm.axes[0]) : arm.axes[0];
}

/// The axis of the base frame that is farthest from a direction, brought across it.
Vector3<double> across(const Vector3<double>& direction) {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(direction[i]) < std::abs(direction[least]) - 1e-9) least = i;
  return (Vector3<double>::Unit(least) - direction[least] * direction).normalized();
}

ReferencePlane from_zero(const Vector3<double>& zero, const Vector3<double>& line) {
  return {zero, line.cross(zero), false};
}

ReferencePlane any_plane(const Vector3<double>& line) {
  ReferencePlane plane = from_zero(across(line), line);
  plane.undefined = true;
  return plane;
}

/// The direction, which is across the half line, mirrored so that the half line becomes the line: elsewhere
/// than on the half line where the shortest turn from its opposite carries the direction.
ReferencePlane stereographic_plane(const Vector3<double>& half_line, const Vector3<double>& direction,
                                   const Vector3<double>& line) {
  const Vector3<double> way = line - half_line;
  const double square = way.squaredNorm();
  if (square < no_direction * no_direction) return any_plane(line);
  const Vector3<double> mirrored = direction - (2 * way.dot(direction) / square) * way;
  return from_zero((mirrored - mirrored.dot(line) * line).normalized(), line);
}

}  // namespace

ReferencePlane reference_plane(const Arm& arm, const ArmAngleReference& reference,
                               const Vector3<double>& line) {
  if (reference.kind == ArmAngleReference::Kind::stereographic) {
    const Vector3<double> half_line =
        is_zero(reference.half_line) ? Vector3<double>(-upwards(arm)) : reference.half_line.normalized();
    const Vector3<double> given = reference.direction - reference.direction.dot(half_line) * half_line;
    const bool own = given.norm() <= no_direction * reference.direction.norm();
    return stereographic_plane(half_line, own ? across(half_line) : given.normalized(), line);
  }
  const Vector3<double> direction =
      is_zero(reference.direction) ? upwards(arm) : reference.direction.normalized();
  // Twice the cross product: the part of the direction across the line, to the last digit where it is short.
  const Vector3<double> zero = line.cross(direction).cross(line);
  const double sine = zero.norm();
  if (!(sine >= no_direction)) return any_plane(line);
  return from_zero(zero / sine, line);
}

Elbow::Elbow(const Arm& arm) : axis_(arm.axes[3]), planar_(arm.planar) {
  const Vector3<double> upper = arm.elbow - arm.shoulder;
  const Vector3<double> forearm = arm.wrist - arm.elbow;
  along_ = planar_ ? 0 : axis_.dot(forearm);
  const Vector3<double> swinging = forearm - along_ * axis_;
  upper_length_ = upper.norm();
  forearm_length_ = swinging.norm();
  forward_ = upper / upper_length_;
  const double height = along_ * along_;
  const double sum = upper_length_ + forearm_length_, difference = upper_length_ - forearm_length_;
  most_ = sum * sum + height;
  least_ = difference * difference + height;
  longest_ = std::sqrt(most_);
  stretched_ = {forward_.dot(swinging) / forearm_length_,
                axis_.cross(swinging).dot(forward_) / forearm_length_};
}

Elbow::Bent Elbow::at_shares(double low, double high, double sense) const {
  const double cosine = std::sqrt(high), sine = std::sqrt(low);
  return bent({(cosine - sine) * (cosine + sine), sense * 2 * cosine * sine}, sense);
}

Elbow::Bent Elbow::at_angle(double angle) const {
  const Rotor<double> bend = Rotor<double>{std::cos(angle), std::sin(angle)} * inverse::inverse(stretched_);
  return bent(bend, bend.sine < 0 ? -1 : 1);
}

Elbow::Bent Elbow::bent(const Rotor<double>& bend, double sense) const {
  const Vector3<double> sideways = axis_.cross(forward_);
  const double ahead = upper_length_ + forearm_length_ * bend.cosine, beside = forearm_length_ * bend.sine;
  const double distance = std::sqrt(ahead * ahead + beside * beside + along_ * along_);
  // A wrist on the shoulder has the direction in which it leaves.
  const bool vanishes = distance <= no_direction * longest_;
  const Vector3<double> line =
      vanishes ? Vector3<double>(sense * sideways)
               : Vector3<double>((ahead / distance) * forward_ + (beside / distance) * sideways +
                                 (along_ / distance) * axis_);
  // A straight or folded elbow has the plane in which it bends.
  const Vector3<double> normal = planar_ ? Vector3<double>(sense * axis_)
                                         : Vector3<double>((beside * axis_ - along_ * sideways).normalized());
  return {bend * stretched_, line, line.cross(normal), -normal};
}

Matrix3<double> Swivel::rotation(double psi) const {
  const double cosine = std::cos(psi), sine = std::sin(psi);
  const Vector3<double> side = cosine * plane.zero + sine * plane.quarter;
  const Vector3<double> normal = cosine * plane.quarter - sine * plane.zero;
  return line * elbow.line.transpose() + side * elbow.side.transpose() + normal * elbow.normal.transpose();
}

Swivel::Wave Swivel::wave(const Vector3<double>& p, const Vector3<double>& q, double value) const {
  const double p_zero = p.dot(plane.zero), p_quarter = p.dot(plane.quarter);
  const double q_side = q.dot(elbow.side), q_normal = q.dot(elbow.normal);
  return {p_zero * q_side + p_quarter * q_normal, p_quarter * q_side - p_zero * q_normal,
          p.dot(line) * q.dot(elbow.line) - value};
}

namespace {

bool is_valid(const ArmAngleReference& reference) {
  return reference.direction.allFinite() && reference.half_line.allFinite();
}

}  // namespace

Goal goal_of(const Arm& arm, const Elbow& elbow, const Pose<double>& given,
             const ArmAngleReference& reference, double tolerance) {
  const Pose<double> pose = pose_meant(given).value_or(given);
  Goal goal;
  const double reach = elbow.longest() + (arm.tool.position - arm.wrist).norm() + arm.shoulder.norm();
  if (reach_test(pose, reach, tolerance) != ReachTest::open || !is_valid(reference)) {
    goal.status = is_valid(reference) ? status_beyond(pose) : Status::invalid;
    return goal;
  }
  const Pose<double> unit = pose.normalised();
  goal.rotation = (unit.orientation * arm.tool.orientation.conjugate()).toRotationMatrix();
  const Vector3<double> way = unit.position + goal.rotation * (arm.wrist - arm.tool.position) - arm.shoulder;
  const double square = way.squaredNorm();
  const double range = elbow.most_square() - elbow.least_square();
  // A miss in the distance, as one in its square.
  const double miss = 2 * elbow.longest() * (tolerance + 1e-15) * reach;
  if (square > elbow.most_square() + miss || square < elbow.least_square() - miss) return goal;
  goal.low = smaller(not_negative((elbow.most_square() - square) / range), 1.0);
  goal.high = smaller(not_negative((square - elbow.least_square()) / range), 1.0);
  // An elbow that rounding cannot tell from a straight or folded one is one: the wrist is as good as where it
  // was.
  const double distance = std::sqrt(square);
  const double end = std::sqrt(goal.low < goal.high ? elbow.most_square() : elbow.least_square());
  const bool is_end = std::abs(distance - end) <= 1e-14 * reach;
  if (is_end) {
    goal.low = goal.low < goal.high ? 0 : 1;
    goal.high = 1 - goal.low;
    goal.elbows = arm.planar ? 2 : 1;
    goal.is_one_elbow = arm.planar;
  }
  const bool vanishes = distance <= no_direction * elbow.longest();
  goal.line = vanishes ? upwards(arm) : Vector3<double>(way / distance);
  goal.plane = reference_plane(arm, reference, goal.line);
  goal.undefined = vanishes || goal.plane.undefined || (arm.planar && is_end);
  goal.status = Status::solved;
  return goal;
}

}  // namespace qvgen::inverse::arm_angle
