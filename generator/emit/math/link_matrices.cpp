// SPDX-License-Identifier: MIT
#include "emit/math/link_matrices.h"

#include "canonical/arm.h"
#include "symbolic/model.h"

namespace qvgen::emit {
namespace {

using namespace symbolic;
using GiNaC::ex;

const Matrix3 unit_matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// cos(angle) 1 + (1 - cos(angle)) u u^T + sin(angle) [u], u a unit vector.
Matrix3 turn(const Vector& axis, const ex& angle) {
  const std::array<ex, 3> u{axis.x, axis.y, axis.z};
  const Matrix3 across{{{0, -axis.z, axis.y}, {axis.z, 0, -axis.x}, {-axis.y, axis.x, 0}}};
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const ex along = u[i] * u[j];
      result[i][j] =
          along + (unit_matrix[i][j] - along) * GiNaC::cos(angle) + across[i][j] * GiNaC::sin(angle);
    }
  return result;
}

/// Half angles fold to numbers; in full angles a twist that is a symbol reads better.
Matrix3 rotation_of(const model::Displacement& displacement) {
  Matrix3 result = unit_matrix;
  for (const model::Turn& part : displacement.turns) {
    const Vector axis = to_symbolic(part.axis);
    const ex angle = to_symbolic(part.angle);
    result =
        result * (canonical::is_known(part.angle) ? to_matrix(rotation(axis, angle)) : turn(axis, angle));
  }
  return result;
}

}  // namespace

LinkMatrix matrix_of(const model::Displacement& displacement) {
  return {rotation_of(displacement), to_symbolic(displacement.translation)};
}

LinkMatrix matrix_of(const model::Joint& joint) {
  const bool turns = joint.type == model::JointType::revolute;
  const Vector axis = to_symbolic(joint.axis);
  const ex variable = symbol(joint.variable);
  const LinkMatrix before = matrix_of(joint.before);
  const LinkMatrix after = matrix_of(joint.after);
  const Matrix3 moved = turns ? turn(axis, variable) : unit_matrix;
  const Vector way = moved * after.position + (turns ? Vector{} : variable * axis);
  return {before.rotation * (moved * after.rotation), before.position + before.rotation * way};
}

}  // namespace qvgen::emit
