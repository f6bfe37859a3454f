// SPDX-License-Identifier: MIT
#include "other_notation.h"

#include <cstdlib>
#include <fstream>

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

/// R I R^T of a symmetric matrix xx, yy, zz, xy, yz, xz.
std::array<Expression, 6> rotated(const std::vector<model::Turn>& turns,
                                  const std::array<Expression, 6>& inertia) {
  const auto& [xx, yy, zz, xy, yz, xz] = inertia;
  std::array<model::Vector3, 3> rows = {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  for (model::Vector3& row : rows) row = model::rotate(turns, row);
  std::array<model::Vector3, 3> columns;
  for (std::size_t k = 0; k < 3; ++k)
    columns[k] = model::rotate(turns, model::Vector3{rows[0][k], rows[1][k], rows[2][k]});
  return {columns[0][0], columns[1][1], columns[2][2], columns[1][0], columns[2][1], columns[2][0]};
}

/// Returns the inertia of a link in a frame that is given in the link's old one.
model::Inertia seen_from(const Displacement& frame, model::Inertia inertia) {
  const Displacement back = inverse(frame);
  inertia.inertia = rotated(back.turns, inertia.inertia);
  if (!inertia.mass.is_literal_zero())
    inertia.centre_of_mass = model::add(model::rotate(back.turns, inertia.centre_of_mass), back.translation);
  return inertia;
}

Displacement random_frame(std::mt19937& random) {
  Displacement frame = turned_by_right_angles(random);
  for (Expression& length : frame.translation) length = Expression(cln::cl_RA(pick(random, 5)) / 10);
  return frame;
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

model::Robot with_random_inertias(model::Robot robot, InertiasIn kind, std::mt19937& random) {
  int number = 0;
  const auto value = [&](int from) {
    const Expression hundredths(cln::cl_RA(from + static_cast<int>(pick(random, 50))) / 100);
    if (kind == InertiasIn::numbers) return hundredths;
    const std::string name = "p" + std::to_string(++number);
    robot.inertia_parameters.push_back({name, hundredths});
    return Expression::symbol(name);
  };
  for (model::Joint& joint : robot.joints) {
    joint.inertia.mass = value(100);
    for (Expression& component : joint.inertia.centre_of_mass)
      if (pick(random, 2) == 0) component = value(-25);
    for (std::size_t k = 0; k < 6; ++k)
      if (k < 3 || pick(random, 2) == 0) joint.inertia.inertia[k] = value(k < 3 ? 50 : -25);
    if (pick(random, 2) == 0) joint.drive = {value(1), value(1), value(1)};
  }
  return robot;
}

model::Robot with_free_inertias(model::Robot robot) {
  const auto symbol = [&robot] {
    const std::string name = "p" + std::to_string(robot.inertia_parameters.size() + 1);
    robot.inertia_parameters.push_back({name, std::nullopt});
    return Expression::symbol(name);
  };
  for (model::Joint& joint : robot.joints) {
    joint.drive = {};
    joint.inertia.mass = symbol();
    for (Expression& component : joint.inertia.centre_of_mass) component = symbol();
    for (Expression& entry : joint.inertia.inertia) entry = symbol();
  }
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
    const Displacement frame = random_frame(random);
    joint.after = model::compose(joint.after, frame);
    joint.inertia = seen_from(frame, joint.inertia);
    Displacement& next = i + 1 < other.joints.size() ? other.joints[i + 1].before : other.tool;
    next = model::compose(inverse(frame), next);
  }
  return other;
}

nlohmann::json committed_counts(const std::string& robot) {
  std::ifstream file(QVGEN_SOURCE_DIR "/generated/operation_counts.json");
  return nlohmann::json::parse(file).at(robot);
}

bool is_long_run() { return std::getenv("QVGEN_ARMS") != nullptr; }

}  // namespace qvgen::test
