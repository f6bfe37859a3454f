// SPDX-License-Identifier: MIT
#include "derive/inverse/target.h"

#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using symbolic::Vector;

Target::Target(Builder& builder, const symbolic::Pair& home) : builder_(builder), home_(home) {
  Scope& scope = builder.scope();
  pose_ = {scope.quaternion(names::pose_quaternion), scope.vector(names::pose_position)};
  const symbolic::Quaternion q = scope.unscaled(names::pose_given, names::pose_scale, pose_.q);
  const symbolic::Matrix3 matrix = symbolic::to_matrix(q);
  const GiNaC::ex scale = symbolic::symbol(names::pose_scale);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const GiNaC::ex unit = i == j ? 1 : 0;
      matrix_[i][j] =
          scope.define(builder.plan().target, "turn_" + std::to_string(i + 1) + std::to_string(j + 1),
                       unit - scale * (unit - matrix[i][j]));
    }
  }
  const Vector wide{pose_.p.x, pose_.p.y, pose_.p.z};
  GiNaC::ex arm = scope.clean(dot(home.p, home.p));
  if (scope.held()) arm = scope.clean(scope.held()->at_zero(arm));
  scope.define(builder.plan().target, names::size_square, dot(wide, wide) + arm);
}

void read_unit_quaternion(symbolic::Program& program) {
  GiNaC::exmap unit = {{symbolic::symbol(names::pose_scale), 1}};
  for (const char* part : {"_w", "_x", "_y", "_z"})
    unit[symbolic::symbol(std::string(names::pose_given) + part)] =
        symbolic::symbol(std::string(names::pose_quaternion) + part);
  symbolic::Program result;
  for (const symbolic::Program::Step& step : program.steps())
    result.append({step.name, step.value.subs(unit)});
  for (const symbolic::Program::Output& output : program.outputs())
    result.output(output.name, output.value.subs(unit));
  program = result;
}

Vector Target::image(const Vector& x) const {
  const Scope& scope = builder_.scope();
  const Vector local = scope.clean(symbolic::inverse(home_) * x);
  return matrix_ * local + pose_.p;
}

Vector Target::source(const Vector& x) const {
  return home_ * (symbolic::transpose(matrix_) * (x - pose_.p));
}

Vector Target::direction_image(const Vector& v) const {
  return matrix_ * symbolic::rotate(symbolic::inverse(home_.q), v);
}

Vector Target::direction_source(const Vector& v) {
  return symbolic::rotate(home_.q, symbolic::transpose(matrix_) * v);
}

const symbolic::Quaternion& Target::orientation(const symbolic::Quaternion& home) {
  if (!named_) {
    const Scope& scope = builder_.scope();
    const symbolic::Quaternion q = pose_.q * symbolic::inverse(home);
    orientation_ = builder_.scope().define(
        builder_.plan().target, "target_q",
        symbolic::Quaternion{scope.clean(q.w), scope.clean(q.x), scope.clean(q.y), scope.clean(q.z)});
    named_ = true;
  }
  return orientation_;
}

}  // namespace qvgen::derive::inverse
