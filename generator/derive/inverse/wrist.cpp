// SPDX-License-Identifier: MIT
#include "derive/inverse/wrist.h"

#include "derive/inverse/names.h"
#include "derive/inverse/size.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Matrix3;
using symbolic::Quaternion;
using symbolic::Vector;

namespace {

/// Unit quaternion of a constant rotation matrix, its largest component taken from the diagonal.
Quaternion quaternion_of(const Matrix3& r, const Scope& scope) {
  const std::array<ex, 4> squares = {1 + r[0][0] + r[1][1] + r[2][2], 1 + r[0][0] - r[1][1] - r[2][2],
                                     1 - r[0][0] + r[1][1] - r[2][2], 1 - r[0][0] - r[1][1] + r[2][2]};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (scope.sample(squares[i]) > scope.sample(squares[largest]) + 1e-9) largest = i;
  const ex twice = GiNaC::sqrt(scope.clean(squares[largest]));  // twice the largest component
  const auto part = [&](const ex& value) { return scope.clean(scope.clean(value) / (2 * twice)); };
  const ex half = scope.clean(twice / 2);
  const ex x = part(r[2][1] - r[1][2]), y = part(r[0][2] - r[2][0]), z = part(r[1][0] - r[0][1]);
  const ex xy = part(r[0][1] + r[1][0]), xz = part(r[0][2] + r[2][0]), yz = part(r[1][2] + r[2][1]);
  switch (largest) {
    case 0:
      return {half, x, y, z};
    case 1:
      return {x, half, xy, xz};
    case 2:
      return {y, xy, half, yz};
    default:
      return {z, xz, yz, half};
  }
}

struct Frame {
  Vector normal;
  Quaternion orientation;  ///< of [normal, axis x normal, axis]
};

Frame frame(const Vector& normal_direction, const Vector& axis, const Scope& scope) {
  const Vector raw = scope.clean(normal_direction);
  const Vector normal = scope.clean(ex(1) / GiNaC::sqrt(scope.clean(dot(raw, raw))) * raw);
  const Vector side = scope.clean(cross(axis, normal));
  return {normal,
          quaternion_of(
              {{{normal.x, side.x, axis.x}, {normal.y, side.y, axis.y}, {normal.z, side.z, axis.z}}}, scope)};
}

struct HalfAngle {
  ex cosine, sine;
};
HalfAngle half_angle(const Vector& a, const Vector& b, const Scope& scope) {
  const ex cosine = scope.clean(dot(a, b));
  return {GiNaC::sqrt(scope.clean((1 + cosine) / 2)), GiNaC::sqrt(scope.clean((1 - cosine) / 2))};
}

void name_joint(Builder& builder, const Screw& screw) {
  builder.scope().turn(screw.variable);
  if (screw.joint < 0) return;
  auto& value = builder.plan().joints[static_cast<std::size_t>(screw.joint)];
  value = {true, names::cosine(screw.variable), names::sine(screw.variable)};
}

/// Constants of a wrist: its twists in half angles, and the angle between its normals.
struct Shape {
  ex cosine_sum, sine_sum, cosine_difference, sine_difference, product, cosine_delta, sine_delta;

  [[nodiscard]] bool is_right() const {
    return cosine_sum.is_zero() && sine_difference.is_zero() && sine_delta.is_zero();
  }
};

Shape shape_of(const Screw& first, const Screw& middle, const Screw& last, const Vector& first_normal,
               const Vector& last_normal, const Scope& scope) {
  const HalfAngle a = half_angle(first.axis, middle.axis, scope);
  const HalfAngle b = half_angle(middle.axis, last.axis, scope);
  return {scope.clean(a.cosine * b.cosine - a.sine * b.sine),
          scope.clean(a.sine * b.cosine + a.cosine * b.sine),
          scope.clean(a.cosine * b.cosine + a.sine * b.sine),
          -scope.clean(a.sine * b.cosine - a.cosine * b.sine),
          scope.clean(4 * a.cosine * a.sine * b.cosine * b.sine),
          scope.clean(dot(first_normal, last_normal)),
          scope.clean(dot(middle.axis, cross(first_normal, last_normal)))};
}

kind::RightWrist right_wrist(Step& step, const kind::Wrist& wrist, bool opposite_normals,
                             const Quaternion& u) {
  // u = -i conj(U11), v = -i conj(U12) with U11 = u_w - i u_z, U12 = -u_y - i u_x; at opposite normals the
  // branch with the positive middle angle has the other sign of u.
  const int sign = opposite_normals ? -1 : 1;
  step.before.output("u_x", sign * u.z);
  step.before.output("u_y", -sign * u.w);
  step.before.output("v_x", u.x);
  step.before.output("v_y", u.y);
  step.degenerate = "first and last axis in line: their sum or difference is free";
  return {wrist, !opposite_normals};
}

kind::ObliqueWrist oblique_wrist(Step& step, const kind::Wrist& wrist, const Shape& shape,
                                 const Quaternion& u) {
  step.before.output("u_x", u.w);
  step.before.output("u_y", -u.z);
  step.before.output("v_x", -u.y);
  step.before.output("v_y", -u.x);
  step.before.output("cosine_sum", shape.cosine_sum);
  step.before.output("sine_sum", shape.sine_sum);
  step.before.output("cosine_difference", shape.cosine_difference);
  step.before.output("sine_difference", shape.sine_difference);
  step.before.output("product", shape.product);
  step.before.output("cosine_delta", shape.cosine_delta);
  step.before.output("sine_delta", shape.sine_delta);
  step.degenerate = "edge of the wrist's range: the two solutions coincide";
  return {wrist};
}

/// Directions of nested sines and roots: what is made of longer ones has no end.
constexpr std::size_t longest_direction = 200;

}  // namespace

bool is_wrist(const Screw& first, const Screw& middle, const Screw& last, const Scope& scope) {
  if (!first.revolute || !middle.revolute || !last.revolute) return false;
  const Vector n1 = scope.clean(cross(first.axis, middle.axis));
  const Vector n2 = scope.clean(cross(middle.axis, last.axis));
  if (scope.is_zero(n1) || scope.is_zero(n2)) return false;
  for (const ex& entry : {n1.x, n1.y, n1.z, n2.x, n2.y, n2.z})
    if (!scope.is_known(entry) || nodes(entry) > longest_direction) return false;
  return true;
}

namespace {

/// The step but for what follows it.
Step wrist_step(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                const Quaternion& rotation, kind::Wrist wrist) {
  const Scope& scope = builder.scope();
  const Frame f4 = frame(cross(first.axis, middle.axis), first.axis, scope);
  const Frame f6 = frame(cross(middle.axis, last.axis), last.axis, scope);
  const Quaternion product = symbolic::inverse(f4.orientation) * (rotation * f6.orientation);
  const Quaternion u{scope.clean(product.w), scope.clean(product.x), scope.clean(product.y),
                     scope.clean(product.z)};
  const Shape shape = shape_of(first, middle, last, f4.normal, f6.normal, scope);
  for (const Screw* screw : {&first, &middle, &last}) {
    name_joint(builder, *screw);
    wrist.variables.push_back(screw->variable);
    wrist.joints.push_back(screw->joint);
  }
  Step step;
  step.branches = 2;
  step.joint = middle.joint;
  step.unknown = first.variable + ", " + middle.variable + ", " + last.variable;
  step.equation = "the orientation that the wrist's three axes have to make, in half angles";
  if (shape.is_right())
    step.kind = right_wrist(step, wrist, scope.sample(shape.cosine_delta) < 0, u);
  else
    step.kind = oblique_wrist(step, wrist, shape, u);
  return step;
}

}  // namespace

void solve_wrist(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                 const Quaternion& rotation, const Scope::Turn* choice) {
  kind::Wrist wrist;
  wrist.ends_the_plan = choice == nullptr;
  Step step = wrist_step(builder, first, middle, last, rotation, std::move(wrist));
  if (choice != nullptr) {
    step.before.output("choice_x", choice->cosine);
    step.before.output("choice_y", choice->sine);
  }
  builder.plan().steps.push_back(std::move(step));
}

void solve_wrist_of_seed(Builder& builder, const Screw& first, const Screw& middle, const Screw& last,
                         const Quaternion& rotation) {
  kind::Wrist wrist;
  wrist.ends_the_plan = false;
  wrist.seeded = true;
  builder.plan().steps.push_back(wrist_step(builder, first, middle, last, rotation, std::move(wrist)));
}

}  // namespace qvgen::derive::inverse
