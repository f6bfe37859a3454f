// SPDX-License-Identifier: MIT
#include "derive/inverse/orientation.h"

#include "derive/inverse/names.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::Quaternion;
using symbolic::Vector;

namespace {

struct Group {
  Vector axis;
  std::string name;
  Flat turn;  ///< cosine and sine of the sum of the angles
};

/// Solved revolute joints in order, parallel neighbours (prismatic ones between them do not turn) added up.
std::vector<Group> groups(Builder& builder, const std::vector<Screw>& joints) {
  const Scope& scope = builder.scope();
  std::vector<Group> result;
  for (const Screw& joint : joints) {
    if (!joint.revolute) continue;
    const Scope::Turn value = builder.value(joint);
    const bool joins = !result.empty() && scope.is_zero(symbolic::cross(result.back().axis, joint.axis));
    if (!joins) {
      result.push_back({joint.axis, joint.variable, {value.cosine, value.sine}});
      continue;
    }
    Group& group = result.back();
    const bool same_way = scope.sample(dot(group.axis, joint.axis)) > 0;
    group.turn = group.turn * Flat{value.cosine, same_way ? value.sine : ex(-value.sine)};
    group.name += "_" + joint.variable;
  }
  return result;
}

Quaternion half_turn_back(Builder& builder, const Group& group) {
  const Scope::Turn half = builder.half(group.name, group.turn.x, group.turn.y);
  return {half.cosine, -half.sine * group.axis.x, -half.sine * group.axis.y, -half.sine * group.axis.z};
}

Quaternion keep(Builder& builder, const std::string& name, const Quaternion& q) {
  return {builder.keep(name + "_w", q.w), builder.keep(name + "_x", q.x), builder.keep(name + "_y", q.y),
          builder.keep(name + "_z", q.z)};
}

}  // namespace

Quaternion without_first(Builder& builder, const std::vector<Screw>& joints, Quaternion rotation) {
  for (const Group& group : groups(builder, joints)) {
    const Quaternion back = half_turn_back(builder, group);
    rotation = keep(builder, names::orientation_without(group.name), back * rotation);
  }
  return rotation;
}

Quaternion without_last(Builder& builder, const std::vector<Screw>& joints, Quaternion rotation) {
  std::vector<Group> all = groups(builder, joints);
  for (auto group = all.rbegin(); group != all.rend(); ++group) {
    const Quaternion back = half_turn_back(builder, *group);
    rotation = keep(builder, "before_" + group->name, rotation * back);
  }
  return rotation;
}

}  // namespace qvgen::derive::inverse
