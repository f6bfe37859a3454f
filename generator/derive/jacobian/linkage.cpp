// SPDX-License-Identifier: MIT
#include "derive/jacobian/linkage.h"

#include "derive/kinematics/zero_reference.h"
#include "model/arithmetic.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;

namespace {

/// Collects pivots on the way along the chain.
class Walk {
 public:
  explicit Walk(const model::Robot& robot) {
    for (const model::Joint& joint : robot.joints) linkage_.variables.push_back(symbol(joint.variable));
  }

  void go(const Vector& offset) { way_.offset = way_.offset + offset; }

  void joint(std::size_t index, model::JointType type, const Vector& axis) {
    if (type == model::JointType::prismatic)
      way_.slides.push_back({index, axis});
    else
      turn(axis, linkage_.variables[index], static_cast<int>(index));
  }

  void turn(const Vector& axis, const GiNaC::ex& angle, int joint) {
    linkage_.pivots.push_back({way_, axis, angle, joint});
    way_ = {};
  }

  void constant(const model::Displacement& displacement) {
    go(to_symbolic(displacement.translation));
    for (const model::Turn& each : displacement.turns)
      turn(to_symbolic(each.axis), to_symbolic(each.angle), -1);
  }

  Linkage finish(const Quaternion& home) {
    linkage_.beyond = way_;
    linkage_.home = home;
    return std::move(linkage_);
  }

 private:
  Linkage linkage_;
  Linkage::Way way_;
};

Linkage from(const model::Robot& robot, const ZeroReferenceChain& chain) {
  Walk walk(robot);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    walk.go(chain.joints[i].offset);
    walk.joint(i, chain.joints[i].type, chain.joints[i].axis);
  }
  walk.go(chain.tool_offset);
  return walk.finish(chain.home);
}

}  // namespace

Linkage linkage(const model::Robot& robot) {
  if (const auto chain = zero_reference_chain(robot)) return from(robot, *chain);
  Walk walk(robot);
  walk.constant(robot.base);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    walk.constant(robot.joints[i].before);
    walk.joint(i, robot.joints[i].type, to_symbolic(robot.joints[i].axis));
    walk.constant(robot.joints[i].after);
  }
  walk.constant(robot.tool);
  return walk.finish({});
}

model::Robot with_free_tool_point(const model::Robot& robot) {
  model::Robot result = robot;
  model::Displacement point;
  for (std::size_t i = 0; i < 3; ++i)
    point.translation[i] = model::Expression::symbol(std::string("point.") + "xyz"[i]);
  result.tool = model::compose(robot.tool, point);
  return result;
}

}  // namespace qvgen::derive
