// SPDX-License-Identifier: MIT
#include "calibrate/geometry.h"

#include <algorithm>

#include "model/followers.h"

namespace qvgen::calibrate {
namespace {

constexpr double nearly_parallel = 1e-2;  ///< rad
constexpr double nearly_zero = 1e-6;      ///< m

template <class Values>
Vec<typename Values::Scalar> vector_of(const model::Vector3& v, Values& values) {
  return {values.number(v[0]), values.number(v[1]), values.number(v[2])};
}

template <class Values>
Rigid<typename Values::Scalar> rigid_of(const model::Displacement& displacement, Values& values) {
  auto result = identity(values.one());
  for (const model::Turn& each : displacement.turns) {
    const auto value = values.circular(each.angle);
    result = result * turn(vector_of(each.axis, values), value.cosine, value.sine, values.one());
  }
  result.position = vector_of(displacement.translation, values);
  return result;
}

double norm(const Vec<double>& v) { return std::sqrt(dot(v, v)); }

void make_unit(Vec<double>& v) { v = (1 / norm(v)) * v; }
void make_unit(Vec<Field>&) {}  // directions of derivatives may have any length

/// Returns what is needed of the axis before the gap: its direction and a point of it, seen behind the gap.
template <class S>
struct Before {
  Vec<S> axis, to_here;
};
template <class S>
Before<S> before_of(const Rigid<S>& way, const Vec<S>& axis) {
  return {turned_back(way, axis), turned_back(way, way.position)};
}

template <class S>
Vec<S> across(const Vec<S>& v, const Vec<S>& axis) {
  return v - dot(v, axis) * axis;
}

GapClass class_of(const Before<double>& before, const Vec<double>& axis) {
  GapClass result;
  result.parallel = norm(cross(before.axis, axis)) < nearly_parallel;
  result.coincident = norm(across(before.to_here, axis)) < nearly_zero;
  while (std::abs(axis[result.helper]) > 0.8) ++result.helper;
  return result;
}

/// Returns u: along the common normal; from axis to axis where they are parallel; any where they are one
/// line.
template <class S>
Vec<S> normal_of(const Before<S>& before, const Vec<S>& axis, const GapClass& class_of_gap, const S& one) {
  if (!class_of_gap.parallel) return cross(before.axis, axis);
  if (!class_of_gap.coincident) return across(before.to_here, axis);
  return across(identity(one).axes[class_of_gap.helper], axis);
}

template <class Values>
class Builder {
 public:
  using S = typename Values::Scalar;
  Builder(const model::Robot& robot, Values values) : robot_(robot), values_(std::move(values)) {}

  /// Returns the ways of all gaps and the axes behind them; the tool's gap has no axis.
  std::vector<std::pair<Rigid<S>, Vec<S>>> parts() {
    std::vector<std::pair<Rigid<S>, Vec<S>>> result;
    Rigid<S> rest = rigid_of(robot_.base, values_);
    for (const model::Joint& joint : robot_.joints) {
      result.emplace_back(rest * rigid_of(joint.before, values_), vector_of(joint.axis, values_));
      rest = rigid_of(joint.after, values_);
    }
    result.emplace_back(rest * rigid_of(robot_.tool, values_), Vec<S>{});
    return result;
  }

  void add_bodies(Geometry<S>& geometry) {
    for (const model::Joint& joint : robot_.joints)
      geometry.bodies.push_back(
          {values_.number(joint.inertia.mass),
           rigid_of(joint.after, values_) * vector_of(joint.inertia.centre_of_mass, values_)});
  }

  Geometry<S> geometry(const std::vector<GapClass>& classes) {
    Geometry<S> result;
    const auto all = parts();
    const S one = values_.one();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      const auto& [way, axis] = all[i];
      const auto before = i == 0 ? Before<S>{axis, axis} : before_of(way, all[i - 1].second);
      Vec<S> u = normal_of(before, axis, classes[i], one);
      make_unit(u);
      result.gaps.push_back({way, {u, cross(axis, u), axis}});
    }
    result.gaps.push_back({all.back().first, identity(one).axes});
    add_joints(result);
    return result;
  }

 private:
  void add_joints(Geometry<S>& geometry) {
    for (const model::Joint& driven : model::driven_joints(robot_))
      geometry.turning.push_back(driven.type == model::JointType::revolute);
    for (const std::vector<model::Share>& row : model::shares(robot_)) {
      JointForm form{robot_.joints[geometry.joints.size()].type == model::JointType::revolute, {}};
      for (const model::Share& share : row)
        form.shares.push_back({share.driven, cln::double_approx(share.ratio), share.ratio});
      geometry.joints.push_back(std::move(form));
    }
  }

  const model::Robot& robot_;
  Values values_;
};

}  // namespace

std::vector<GapClass> classes_of(const model::Robot& robot) {
  Builder<DoubleValues> builder(robot, DoubleValues(robot));
  const auto all = builder.parts();
  std::vector<GapClass> classes;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const auto& [way, axis] = all[i];
    const Before<double> first{axis, {}};
    classes.push_back(class_of(i == 0 ? first : before_of(way, all[i - 1].second), axis));
  }
  return classes;
}

Geometry<double> geometry_of(const model::Robot& robot, const std::vector<GapClass>& classes) {
  return Builder<DoubleValues>(robot, DoubleValues(robot)).geometry(classes);
}

Geometry<Field> field_geometry_of(const model::Robot& robot, const std::vector<GapClass>& classes) {
  return Builder<FieldValues>(robot, FieldValues(robot)).geometry(classes);
}

Rigid<double> link_frame(const model::Robot& robot, std::size_t joints) {
  const DoubleValues values(robot);
  return joints == 0 ? identity(1.0) : rigid_of(robot.joints.at(joints - 1).after, values);
}

void add_bodies(const model::Robot& robot, Geometry<double>& geometry, Geometry<Field>& field) {
  Builder<DoubleValues>(robot, DoubleValues(robot)).add_bodies(geometry);
  Builder<FieldValues>(robot, FieldValues(robot)).add_bodies(field);
}

double reach_of(const Geometry<double>& geometry) {
  double sum = 0;
  for (const Gap<double>& gap : geometry.gaps) sum += norm(gap.way.position);
  return std::max(0.1, sum);
}

}  // namespace qvgen::calibrate
