// SPDX-License-Identifier: MIT
#include "derive/kinematics/zero_reference.h"

#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

Vector expand(const Vector& v) { return {v.x.expand(), v.y.expand(), v.z.expand()}; }
Quaternion expand(const Quaternion& q) { return {q.w.expand(), q.x.expand(), q.y.expand(), q.z.expand()}; }

bool vanishes(const ex& e) { return e.expand().is_zero(); }
bool vanishes(const Vector& v) { return vanishes(v.x) && vanishes(v.y) && vanishes(v.z); }

bool is_constant(const ex& e) {
  for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it) || GiNaC::is_a<GiNaC::function>(*it)) return false;
  return true;
}

bool is_constant(const Quaternion& q) {
  return is_constant(q.w) && is_constant(q.x) && is_constant(q.y) && is_constant(q.z);
}

/// The constant displacement since the last joint, in a world-parallel frame.
struct Walk {
  Quaternion orientation;
  Vector offset;

  void step(const model::Displacement& displacement) {
    const Pair pair = to_symbolic(displacement);
    offset = expand(offset + rotate(orientation, pair.p));
    orientation = expand(orientation * pair.q);
  }
};

}  // namespace

int parallel(const Vector& a, const Vector& b) {
  if (vanishes(a - b)) return 1;
  if (vanishes(a + b)) return -1;
  return 0;
}

bool perpendicular(const Vector& a, const Vector& b) { return vanishes(dot(a, b)); }

std::optional<ZeroReferenceChain> zero_reference_chain(const model::Robot& robot) {
  ZeroReferenceChain chain;
  Walk walk;
  walk.step(robot.base);
  for (const model::Joint& joint : robot.joints) {
    walk.step(joint.before);
    if (!is_constant(walk.orientation)) return std::nullopt;
    const Vector axis = expand(rotate(walk.orientation, to_symbolic(joint.axis)));
    chain.joints.push_back({joint.type, joint.variable, walk.offset, axis});
    walk.offset = {};
    walk.step(joint.after);
  }
  walk.step(robot.tool);
  if (!is_constant(walk.orientation)) return std::nullopt;
  chain.tool_offset = walk.offset;
  chain.home = walk.orientation;
  return chain;
}

}  // namespace qvgen::derive
