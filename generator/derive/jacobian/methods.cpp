// SPDX-License-Identifier: MIT
#include "derive/jacobian/forms.h"
#include "derive/jacobian/rates.h"
#include "derive/kinematics/forward_kinematics.h"
#include "derive/kinematics/turns.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

Vector length(const Linkage& linkage, const Linkage::Way& way) {
  Vector result = way.offset;
  for (const Linkage::Slide& slide : way.slides)
    result = result + linkage.variables[slide.joint] * slide.axis;
  return result;
}

const Linkage::Way& way_behind(const Linkage& linkage, std::size_t pivot) {
  return pivot + 1 < linkage.pivots.size() ? linkage.pivots[pivot + 1].before : linkage.beyond;
}

/// Turns a vector from behind pivot `pivots - 1` into the base frame, pivot by pivot.
Vector to_base(Program& program, const Linkage& linkage, std::size_t pivots, Vector v) {
  for (std::size_t i = pivots; i-- > 0;)
    v = program.let(turned({linkage.pivots[i].axis, linkage.pivots[i].angle}, v));
  return v;
}

/// v, omega of the frame behind pivot `from - 1`, carried on from joint to joint and turned into the base
/// frame.
Twist propagated(Program& program, const Linkage& linkage, std::size_t from, Twist twist, Vector first_way) {
  for (std::size_t i = from;; ++i) {
    const Vector way = i == from ? first_way : length(linkage, way_behind(linkage, i - 1));
    twist.linear = program.let(twist.linear + cross(twist.angular, way));
    if (i == linkage.pivots.size()) break;
    const Turn back{linkage.pivots[i].axis, -linkage.pivots[i].angle};
    twist = {program.let(turned(back, twist.linear)), program.let(turned(back, twist.angular))};
  }
  return {to_base(program, linkage, linkage.pivots.size(), twist.linear),
          to_base(program, linkage, linkage.pivots.size(), twist.angular)};
}

Columns iterative(Program& program, const Linkage& linkage) {
  Columns columns(linkage.variables.size());
  const auto slides = [&](const Linkage::Way& way, std::size_t pivots) {
    for (const auto& slide : way.slides)
      columns[slide.joint] = propagated(program, linkage, pivots, {slide.axis, {}}, {});
  };
  for (std::size_t i = 0; i < linkage.pivots.size(); ++i) {
    const Linkage::Pivot& pivot = linkage.pivots[i];
    slides(pivot.before, i);
    if (pivot.joint < 0) continue;
    columns[static_cast<std::size_t>(pivot.joint)] =
        propagated(program, linkage, i + 1, {{}, pivot.axis}, length(linkage, way_behind(linkage, i)));
  }
  slides(linkage.beyond, linkage.pivots.size());
  return columns;
}

Columns by_cross_products(Program& program, const Linkage& linkage) {
  Columns columns(linkage.variables.size());
  std::vector<Vector> points;
  Vector point;
  const auto go = [&](const Linkage::Way& way, std::size_t pivots) {
    point = program.let(point + to_base(program, linkage, pivots, length(linkage, way)));
    for (const auto& slide : way.slides)
      columns[slide.joint].linear = to_base(program, linkage, pivots, slide.axis);
  };
  for (std::size_t i = 0; i < linkage.pivots.size(); ++i) {
    go(linkage.pivots[i].before, i);
    points.push_back(point);
  }
  go(linkage.beyond, linkage.pivots.size());
  for (std::size_t i = 0; i < linkage.pivots.size(); ++i) {
    const Linkage::Pivot& pivot = linkage.pivots[i];
    if (pivot.joint < 0) continue;
    const Vector axis = to_base(program, linkage, i, pivot.axis);
    columns[static_cast<std::size_t>(pivot.joint)] = {
        program.let(cross(axis, program.let(point - points[i]))), axis};
  }
  return columns;
}

}  // namespace

std::vector<ColumnsForm> textbook_methods(const model::Robot& robot) {
  return {{"iterative propagation of link velocities",
           [=](Program& program) { return iterative(program, linkage(robot)); }},
          {"cross products of axes",
           [=](Program& program) { return by_cross_products(program, linkage(robot)); }},
          {"differentiation of position and quaternion",
           [=](Program& program) { return plain_jacobian(robot, program).columns; }}};
}

}  // namespace qvgen::derive
