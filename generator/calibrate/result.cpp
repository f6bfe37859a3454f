// SPDX-License-Identifier: MIT
#include "calibrate/result.h"

#include <cln/integer.h>
#include <cln/rational.h>

#include "model/arithmetic.h"
#include "model/followers.h"

namespace qvgen::calibrate {
namespace {

using model::Displacement;
using model::Expression;

/// Returns a number with 13 digits behind the point.
Expression rounded(double value) {
  constexpr double digits = 1e13;
  const double whole = std::round(value * digits);
  return Expression(cln::rational(cln::cl_float(whole, cln::float_format(20))) /
                    cln::expt_pos(cln::cl_I(10), 13));
}

/// Returns a small rotation as turns about z, y and x, without those that are zero.
std::vector<model::Turn> turns_of(const Rigid<double>& m) {
  const double pitch = std::asin(std::clamp(-m.axes[0][2], -1.0, 1.0));
  const double roll = std::atan2(m.axes[1][2], m.axes[2][2]);
  const double yaw = std::atan2(m.axes[0][1], m.axes[0][0]);
  std::vector<model::Turn> turns;
  const std::array<std::pair<std::size_t, double>, 3> all{{{2, yaw}, {1, pitch}, {0, roll}}};
  for (const auto& [axis, angle] : all)
    if (const Expression value = rounded(angle); !value.is_literal_zero())
      turns.push_back({model::unit_vector(axis), value});
  return turns;
}

Rigid<double> rigid_of(const Displacement& displacement, const DoubleValues& values) {
  Rigid<double> result = identity(1.0);
  for (const model::Turn& each : displacement.turns) {
    const auto value = values.circular(each.angle);
    result = result * turn(Vec<double>{values.number(each.axis[0]), values.number(each.axis[1]),
                                       values.number(each.axis[2])},
                           value.cosine, value.sine, 1.0);
  }
  return result;
}

/// Appends a small motion to a frame.
Displacement with_error(const Displacement& frame, const Rigid<double>& error, const DoubleValues& values) {
  Displacement result = frame;
  const Vec<double> by = turned(rigid_of(frame, values), error.position);
  for (std::size_t i = 0; i < 3; ++i)
    result.translation.at(i) = model::add(result.translation.at(i), rounded(by.at(i)));
  for (const model::Turn& each : turns_of(error)) result.turns.push_back(each);
  return result;
}

std::vector<model::Turn> reversed(const std::vector<model::Turn>& turns) {
  std::vector<model::Turn> result;
  for (auto each = turns.rbegin(); each != turns.rend(); ++each)
    result.push_back({each->axis, model::negate(each->angle)});
  return result;
}

/// Moves turns behind a joint before it, where a [[joint]] table can say them; its link frame stays.
void turn_before(model::Joint& joint) {
  const std::vector<model::Turn> behind = joint.after.turns, back = reversed(behind);
  joint.before.turns.insert(joint.before.turns.end(), behind.begin(), behind.end());
  joint.axis = model::rotate(back, joint.axis);
  joint.after = {{}, model::rotate(back, joint.after.translation)};
}

/// The axes of the nominal arm, with all joints at zero.
struct Axis {
  Vec<double> direction, point;
};
std::vector<Axis> axes_of(const Geometry<double>& geometry) {
  std::vector<Axis> axes;
  Rigid<double> at = identity(1.0);
  for (std::size_t i = 0; i < geometry.joints.size(); ++i) {
    at = at * geometry.gaps[i].way;
    axes.push_back({turned(at, geometry.gaps[i].directions[2]), at.position});
  }
  return axes;
}

constexpr double tolerance = 1e-9;
double norm(const Vec<double>& v) { return std::sqrt(dot(v, v)); }

bool parallel(const Axis& a, const Axis& b) { return norm(cross(a.direction, b.direction)) < tolerance; }

/// Returns the point where two axes meet.
std::optional<Vec<double>> meeting(const Axis& a, const Axis& b) {
  const Vec<double> normal = cross(a.direction, b.direction), between = b.point - a.point;
  const double square = dot(normal, normal);
  if (square < tolerance || std::abs(dot(between, normal)) > tolerance) return std::nullopt;
  return a.point + (dot(cross(between, b.direction), normal) / square) * a.direction;
}

/// True if neighbouring axes do, which they keep doing when joints move only if the second is between the
/// others.
bool meet(const Axis& a, const Axis& b, const Axis& c) {
  const auto first = meeting(a, b), second = meeting(b, c);
  return first && second && norm(*first - *second) < tolerance;
}

}  // namespace

Rigid<double> error_of(const Model<double>& model, const State& state, std::size_t gap) {
  Rigid<double> error = identity(1.0);
  for (const std::size_t index : model.of_gap[gap]) {
    const Parameter& each = model.parameters[index];
    if (is_of_posture(each.kind)) continue;
    const double amount = state.values[index];
    const Vec<double>& axis = model.geometry.gaps[gap - 1].directions.at(each.direction);
    error =
        error * (each.turn ? turn(axis, std::cos(amount), std::sin(amount), 1.0) : shift(amount * axis, 1.0));
  }
  return error;
}

bool has_closed_form(const Geometry<double>& geometry) {
  const std::vector<Axis> axes = axes_of(geometry);
  std::size_t slides = 0;
  for (const JointForm& joint : geometry.joints) slides += joint.revolute ? 0 : 1;
  if (slides >= 3) return true;
  for (std::size_t i = 0; i + 2 < axes.size(); ++i) {
    const auto turns = [&](std::size_t k) { return geometry.joints[k].revolute; };
    if (!turns(i) || !turns(i + 1) || !turns(i + 2)) continue;
    if (parallel(axes[i], axes[i + 1]) && parallel(axes[i + 1], axes[i + 2])) return true;
    if (meet(axes[i], axes[i + 1], axes[i + 2])) return true;
  }
  return false;
}

model::Robot calibrated_robot(const model::Robot& robot, const Calibration& calibration,
                              const std::string& name) {
  const Model<double>& model = calibration.identifiable.model;
  const DoubleValues values(robot);
  model::Robot result = robot;
  result.name = name;
  result.title = robot.title + ", calibrated";
  for (std::size_t i = 0; i < result.joints.size(); ++i) {
    model::Joint& joint = result.joints[i];
    joint.before = with_error(joint.before, error_of(model, calibration.state, i + 1), values);
    turn_before(joint);
  }
  result.tool = with_error(result.tool, error_of(model, calibration.state, result.joints.size() + 1), values);
  const bool fits = result.joints.size() == 6 && !model::has_followers(result);
  if (robot.ideal.empty() && fits && robot.name != name && has_closed_form(model.geometry))
    result.ideal = robot.name;
  return result;
}

}  // namespace qvgen::calibrate
