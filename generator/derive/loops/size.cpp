// SPDX-License-Identifier: MIT
#include "derive/loops/size.h"

#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

namespace {

ex square_of(const model::Displacement& displacement) {
  const Vector v = symbolic::to_symbolic(displacement.translation);
  return dot(v, v);
}

}  // namespace

ex size_square(const AssemblyPlan& assembly) {
  ex sum = 0;
  for (const model::Joint& joint : assembly.robot.joints)
    sum += square_of(joint.before) + square_of(joint.after);
  for (const Cycle& cycle : assembly.cycles) {
    if (!cycle.length_joint) sum += cycle.length * cycle.length;
    for (const Side& side : cycle.sides) sum += dot(side.point, side.point);
  }
  for (const std::size_t joint : assembly.given) {
    const model::Joint& given = assembly.robot.joints[joint];
    if (given.type == model::JointType::prismatic) sum += GiNaC::pow(symbolic::symbol(given.variable), 2);
  }
  return sum;
}

}  // namespace qvgen::derive::loops
