// SPDX-License-Identifier: MIT
#include "derive/inverse/target.h"

#include "derive/inverse/inverse.h"

namespace qvgen::derive::inverse {

using symbolic::Vector;

Target::Target(Builder& builder, const symbolic::Pair& home) : builder_(builder), home_(home) {
  Scope& scope = builder.scope();
  pose_ = {scope.quaternion(pose_quaternion), scope.vector(pose_position)};
  const symbolic::Matrix3 matrix = symbolic::to_matrix(pose_.q);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      matrix_[i][j] = scope.define(builder.plan().target, "turn_" + std::to_string(i + 1) + std::to_string(j + 1), matrix[i][j]);
  const Vector wide{pose_.p.x, pose_.p.y, pose_.p.z};
  scope.define(builder.plan().target, size_square, dot(wide, wide) + scope.clean(dot(home.p, home.p)));
}

Vector Target::image(const Vector& x) const {
  const Scope& scope = builder_.scope();
  const Vector local = scope.clean(symbolic::inverse(home_) * x);
  return matrix_ * local + pose_.p;
}

Vector Target::source(const Vector& x) const { return home_ * (symbolic::transpose(matrix_) * (x - pose_.p)); }

Vector Target::direction_image(const Vector& v) const { return matrix_ * symbolic::rotate(symbolic::inverse(home_.q), v); }

Vector Target::direction_source(const Vector& v) { return symbolic::rotate(home_.q, symbolic::transpose(matrix_) * v); }

const symbolic::Quaternion& Target::orientation() {
  if (!named_) {
    const Scope& scope = builder_.scope();
    const symbolic::Quaternion q = pose_.q * symbolic::inverse(home_.q);
    orientation_ = builder_.scope().define(builder_.plan().target, "target_q",
                                           symbolic::Quaternion{scope.clean(q.w), scope.clean(q.x), scope.clean(q.y), scope.clean(q.z)});
    named_ = true;
  }
  return orientation_;
}

}  // namespace qvgen::derive::inverse
