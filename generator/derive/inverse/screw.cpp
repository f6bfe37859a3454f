// SPDX-License-Identifier: MIT
#include "derive/inverse/screw.h"

#include <cmath>

#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// Two unit vectors that make an orthonormal right-handed frame with an axis.
struct Completion {
  Vector first, second;
  bool divided = false;  ///< by a length that is no number, and may vanish
};

Completion completion(const Vector& along, const Scope& scope) {
  const std::array<ex, 3> axis = {along.x, along.y, along.z};
  std::size_t least = 0;
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(scope.sample(axis[i])) < std::abs(scope.sample(axis[least])) - 1e-9) least = i;
    if (std::abs(scope.sample(axis[i])) > std::abs(scope.sample(axis[largest])) + 1e-9) largest = i;
  }
  std::array<ex, 3> unit = {0, 0, 0};
  const bool along_axis = scope.is_zero(axis[(largest + 1) % 3]) && scope.is_zero(axis[(largest + 2) % 3]);
  unit[along_axis ? (largest + 1) % 3 : least] = 1;
  Vector first{unit[0], unit[1], unit[2]};
  bool divided = false;
  if (!along_axis) {
    first = scope.clean(cross(along, first));
    const ex square = scope.clean(dot(first, first));
    divided = !Scope::is_number(square);
    first = scope.clean(ex(1) / GiNaC::sqrt(square) * first);
  }
  return {first, scope.clean(cross(along, first)), divided};
}

/// Completes a joint's axis at the zero pose to a frame. If the axis turns with a symbol, the frame turns
/// with it: no length is divided by that may vanish.
Completion completion_of(const model::Joint& joint, const Screw& screw, const Scope& scope) {
  const Completion direct = completion(screw.axis, scope);
  if (!direct.divided) return direct;
  const Completion own = completion(symbolic::to_symbolic(joint.axis), scope);
  if (own.divided) return direct;
  return {symbolic::rotate(screw.frame, own.first), symbolic::rotate(screw.frame, own.second)};
}

constexpr const char* named_part = "chain_";

/// True if the sine of a symbolic twist is in it, or a name that stands for such a thing.
bool holds_twist(const ex& value) {
  if (GiNaC::is_a<GiNaC::function>(value)) return true;
  if (GiNaC::is_a<GiNaC::symbol>(value))
    return GiNaC::ex_to<GiNaC::symbol>(value).get_name().rfind(named_part, 0) == 0;
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (holds_twist(value.op(i))) return true;
  return false;
}

/// Accumulates the displacements of a chain. What a symbolic twist is in gets a name of its own: multiplied
/// out over six joints such expressions have thousands of terms.
class Frames {
 public:
  Frames(Scope& scope, symbolic::Program& constants) : scope_(scope), constants_(constants) {}

  symbolic::Pair clean(const symbolic::Pair& pair) {
    ++count_;
    return {{small(pair.q.w, "qw"), small(pair.q.x, "qx"), small(pair.q.y, "qy"), small(pair.q.z, "qz")},
            {small(pair.p.x, "px"), small(pair.p.y, "py"), small(pair.p.z, "pz")}};
  }
  Vector clean(const Vector& v) {
    ++count_;
    return {small(v.x, "x"), small(v.y, "y"), small(v.z, "z")};
  }

 private:
  ex small(const ex& value, const char* part) {
    const ex cleaned = scope_.clean(value);
    const ex others = scope_.held() ? scope_.held()->left_out(cleaned) : cleaned;
    if (Scope::is_number(cleaned) || !holds_twist(others)) return cleaned;
    const ex settled = scope_.settled(cleaned);
    if (Scope::is_number(settled)) return settled;
    return scope_.define(constants_, named_part + std::to_string(count_) + "_" + part, cleaned);
  }

  Scope& scope_;
  symbolic::Program& constants_;
  int count_ = 0;
};

}  // namespace

Chain chain_of(const model::Robot& robot, Scope& scope, symbolic::Program& constants) {
  Chain chain;
  if (scope.held()) {
    constants.output(scope.held()->cosine, scope.held()->cosine_value);
    constants.output(scope.held()->sine, scope.held()->sine_value);
  }
  Frames frames(scope, constants);
  symbolic::Pair frame = symbolic::to_symbolic(robot.base);
  for (const model::Joint& joint : robot.joints) {
    frame = frames.clean(frame * symbolic::to_symbolic(joint.before));
    Screw screw;
    screw.revolute = joint.type == model::JointType::revolute;
    screw.axis = frames.clean(symbolic::rotate(frame.q, symbolic::to_symbolic(joint.axis)));
    screw.point = frame.p;
    screw.variable = joint.variable;
    screw.joint = static_cast<int>(chain.screws.size());
    screw.frame = frame.q;
    const Completion complete = completion_of(joint, screw, scope);
    screw.first = frames.clean(complete.first);
    screw.second = frames.clean(complete.second);
    chain.screws.push_back(screw);
    frame = frames.clean(frame * symbolic::to_symbolic(joint.after));
  }
  chain.home = frames.clean(frame * symbolic::to_symbolic(robot.tool));
  return chain;
}

std::array<Screw, 3> in_own_frame(const model::Robot& robot, const std::array<std::size_t, 3>& joints,
                                  const Scope& scope) {
  std::array<Screw, 3> screws;
  symbolic::Quaternion frame{1, 0, 0, 0};
  std::size_t found = 0;
  for (std::size_t i = joints.front(); i <= joints.back(); ++i) {
    const model::Joint& joint = robot.joints[i];
    if (i > joints.front()) frame = frame * symbolic::to_symbolic(joint.before).q;
    if (i == joints[found]) {
      Screw& screw = screws[found++];
      screw.revolute = joint.type == model::JointType::revolute;
      screw.axis = scope.clean(symbolic::rotate(frame, symbolic::to_symbolic(joint.axis)));
      screw.variable = joint.variable;
      screw.joint = static_cast<int>(i);
      const Completion complete = completion(screw.axis, scope);
      screw.first = complete.first;
      screw.second = complete.second;
    }
    frame = frame * symbolic::to_symbolic(joint.after).q;
  }
  return screws;
}

Screw reversed(const Screw& screw) {
  Screw result = screw;
  result.axis = -screw.axis;
  result.second = -screw.second;
  return result;
}

Vector apply(const Screw& screw, const ex& value, const ex& sine, const Vector& point) {
  if (!screw.revolute) return point + value * screw.axis;
  const Vector arm = point - screw.point;
  const ex x = dot(screw.first, arm);
  const ex y = dot(screw.second, arm);
  return screw.point + dot(screw.axis, arm) * screw.axis + (value * x - sine * y) * screw.first +
         (sine * x + value * y) * screw.second;
}

}  // namespace qvgen::derive::inverse
