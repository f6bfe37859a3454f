// SPDX-License-Identifier: MIT
#include "other_notation.h"

#include "model/arithmetic.h"

namespace qvgen::test {
namespace {

using model::Displacement;
using model::Expression;

/// 0 to n - 1, by the generator's own bits: the same in every C++ library.
unsigned pick(std::mt19937& random, unsigned n) { return static_cast<unsigned>(random() % n); }

Expression quarters(unsigned count) {
  return model::multiply(Expression(cln::cl_RA(count) / 2), Expression::pi());
}

Displacement turned_by_right_angles(std::mt19937& random) {
  Displacement result;
  for (int i = 0; i < 2; ++i)
    result.turns.push_back({model::unit_vector(pick(random, 3)), quarters(pick(random, 4))});
  return result;
}

Displacement inverse(const Displacement& displacement) {
  Displacement result;
  for (auto turn = displacement.turns.rbegin(); turn != displacement.turns.rend(); ++turn)
    result.turns.push_back({turn->axis, model::negate(turn->angle)});
  result.translation = model::subtract({}, model::rotate(result.turns, displacement.translation));
  return result;
}

Expression random_length(std::mt19937& random) {
  switch (pick(random, 4)) {
    case 0:
      return Expression(cln::cl_RA(1 + pick(random, 9)) / 10);
    case 1:
      return Expression::symbol("l" + std::to_string(1 + pick(random, 5)));
    default:
      return {};
  }
}

Displacement random_displacement(std::mt19937& random) {
  Displacement result = turned_by_right_angles(random);
  for (Expression& length : result.translation) length = random_length(random);
  return result;
}

void reverse(model::Joint& joint) {
  for (Expression& component : joint.axis) component = model::negate(component);
}

}  // namespace

model::Robot random_right_angled_robot(std::mt19937& random) {
  model::Robot robot;
  robot.name = "arm";
  for (int i = 1; i <= 5; ++i) robot.geometry.push_back({"l" + std::to_string(i), Expression(i)});
  robot.base = random_displacement(random);
  const unsigned count = 1 + pick(random, 7);
  for (unsigned i = 1; i <= count; ++i) {
    model::Joint joint;
    joint.type = pick(random, 4) == 0 ? model::JointType::prismatic : model::JointType::revolute;
    joint.variable = "q" + std::to_string(i);
    joint.before = random_displacement(random);
    joint.axis = model::unit_vector(pick(random, 3));
    joint.after = random_displacement(random);
    robot.joints.push_back(joint);
  }
  robot.tool = random_displacement(random);
  return robot;
}

model::Robot in_another_notation(const model::Robot& robot, std::mt19937& random) {
  model::Robot other = robot;
  for (std::size_t i = 0; i < other.joints.size(); ++i) {
    model::Joint& joint = other.joints[i];
    const unsigned zero = pick(random, 4);
    if (joint.type == model::JointType::revolute)
      joint.before = model::compose(joint.before, {{{joint.axis, quarters(zero)}}, {}});
    if (pick(random, 2) == 0) reverse(joint);
    Displacement frame = turned_by_right_angles(random);
    for (Expression& length : frame.translation) length = Expression(cln::cl_RA(pick(random, 5)) / 10);
    joint.after = model::compose(joint.after, frame);
    Displacement& next = i + 1 < other.joints.size() ? other.joints[i + 1].before : other.tool;
    next = model::compose(inverse(frame), next);
  }
  return other;
}

}  // namespace qvgen::test
