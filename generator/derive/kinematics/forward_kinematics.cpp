// SPDX-License-Identifier: MIT
#include "derive/kinematics/forward_kinematics.h"

#include <algorithm>

#include "derive/kinematics/orientation.h"
#include "derive/kinematics/position.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

Pair pair_product(const model::Robot& robot, Program& program) {
  const auto named = [&](const Pair& pair) { return Pair{program.let(pair.q), program.let(pair.p)}; };
  Pair product = named(to_symbolic(robot.base));
  for (const model::Joint& joint : robot.joints) {
    product = named(product * to_symbolic(joint.before));
    product = named(product * motion(joint));
    product = named(product * to_symbolic(joint.after));
  }
  return named(product * to_symbolic(robot.tool));
}

namespace {

void output(Program& program, const Quaternion& q, const Vector& p) {
  program.output("w", q.w);
  program.output("x", q.x);
  program.output("y", q.y);
  program.output("z", q.z);
  program.output("px", p.x);
  program.output("py", p.y);
  program.output("pz", p.z);
}

void output(Program& program, const Matrix3& r, const Vector& p) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) program.output("r" + std::to_string(i + 1) + std::to_string(j + 1), r[i][j]);
  program.output("px", p.x);
  program.output("py", p.y);
  program.output("pz", p.z);
}

Program plain_pose(const model::Robot& robot) {
  Program program;
  const Pair tool = pair_product(robot, program);
  output(program, tool.q, tool.p);
  return program;
}

}  // namespace

Program plain_transform(const model::Robot& robot) {
  Program program;
  const Pair tool = pair_product(robot, program);
  output(program, to_matrix(tool.q), tool.p);
  return program;
}

Quantity forward_kinematics(const model::Robot& robot) {
  Quantity quantity{"forward_kinematics", {{"pair product", plain_pose(robot)}}, plain_pose(robot)};
  const auto chain = zero_reference_chain(robot);
  if (!chain) return quantity;
  // Orientation and position share little but the angles: each orientation is joined with the position in
  // full angles, which has the fewest operations, and with the one in half angles, which needs no further
  // sines; the other forms of the position with the first orientation.
  const auto orientations = orientation_forms(*chain);
  const auto positions = position_forms(*chain);
  const auto add = [&](const OrientationForm& orientation, const PositionForm& position) {
    Program program;
    const Quaternion q = orientation.build(program);
    output(program, q, position.build(program, q));
    quantity.forms.push_back({orientation.name + ", " + position.name, program});
  };
  for (const PositionForm& position : positions) add(orientations.front(), position);
  for (std::size_t i = 1; i < orientations.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) add(orientations[i], positions[j]);
  return quantity;
}

Quantity homogeneous_transform(const model::Robot& robot) {
  Quantity quantity{
      "homogeneous_transform", {{"pair product", plain_transform(robot)}}, plain_transform(robot)};
  const auto chain = zero_reference_chain(robot);
  if (!chain) return quantity;
  const PositionForm position = position_forms(*chain).front();
  for (const MatrixForm& matrix : matrix_forms(*chain)) {
    Program program;
    const Matrix3 r = matrix.build(program);
    output(program, r, position.build(program, {}));
    quantity.forms.push_back({matrix.name, program});
  }
  return quantity;
}

std::optional<Program> closed_form(const model::Robot& robot) {
  const auto chain = zero_reference_chain(robot);
  if (!chain) return std::nullopt;
  Program unnamed;  // stays empty of steps: everything is written out
  const Quaternion q = written_out_orientation(*chain);
  const Vector p = written_out_position(*chain);
  output(unnamed, q, p);
  return unnamed;
}

}  // namespace qvgen::derive
