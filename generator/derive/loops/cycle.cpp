// SPDX-License-Identifier: MIT
#include "derive/loops/cycle.h"

#include <algorithm>
#include <stdexcept>

#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

/// All joints from the base to a link, in order.
std::vector<std::size_t> way_to(const model::Robot& robot, std::size_t link) {
  return link == model::base_link ? std::vector<std::size_t>{} : model::path(robot, model::base_link, link);
}

/// Symbols of the description as the derivation calls them.
class PrivateNames {
 public:
  explicit PrivateNames(const model::Robot& described) {
    for (const model::Parameter& parameter : described.geometry)
      names_[symbolic::symbol(parameter.name)] = symbolic::symbol("g." + parameter.name);
  }
  [[nodiscard]] ex of(const model::Expression& value) const {
    return symbolic::to_symbolic(value).subs(names_, GiNaC::subs_options::no_pattern);
  }
  [[nodiscard]] Vector of(const model::Vector3& v) const { return {of(v[0]), of(v[1]), of(v[2])}; }

 private:
  GiNaC::exmap names_;
};

Vector axis_of(const model::Robot& robot, std::size_t joint) {
  return symbolic::to_symbolic(robot.joints[joint].axis);
}

/// Directions of a side's axes in the common link's frame, all joints at zero.
std::vector<Vector> directions_of(const model::Robot& robot, const Side& side) {
  const Carrier turned{robot, [&](std::size_t joint) {
                         const bool turns = robot.joints[joint].type == model::JointType::revolute;
                         return inverse::Scope::Turn{turns ? 1 : 0, 0};
                       }};
  std::vector<Vector> directions;
  for (std::size_t i = 0; i < side.joints.size(); ++i)
    directions.push_back(
        turned.lifted_direction(side, static_cast<int>(i), axis_of(robot, side.joints[i]), -1));
  return directions;
}

/// The normal of a loop whose joints move in parallel planes.
std::optional<Vector> normal_of(const model::Robot& robot, const Cycle& cycle, const inverse::Scope& scope) {
  std::optional<Vector> normal;
  for (const bool turns : {true, false}) {
    for (const Side& side : cycle.sides) {
      const std::vector<Vector> directions = directions_of(robot, side);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        if ((robot.joints[side.joints[i]].type == model::JointType::revolute) != turns) continue;
        if (turns && !normal) normal = scope.clean(directions[i]);
        if (!normal) return std::nullopt;
        const bool fits =
            turns ? scope.is_zero(cross(directions[i], *normal)) : scope.is_zero(dot(directions[i], *normal));
        if (!fits) return std::nullopt;
      }
    }
  }
  return normal;
}

Cycle cycle_of(const model::Mechanism& mechanism, const model::Robot& robot, std::size_t index,
               const PrivateNames& names) {
  const model::Loop& loop = mechanism.loops.closures[index];
  Cycle cycle;
  cycle.number = index + 1;
  cycle.type = loop.type;
  std::vector<std::size_t> first = way_to(mechanism.robot, loop.links[0]);
  std::vector<std::size_t> second = way_to(mechanism.robot, loop.links[1]);
  const auto apart = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  first.erase(first.begin(), apart.first);
  second.erase(second.begin(), apart.second);
  cycle.sides[0] = {first, names.of(loop.points[0])};
  cycle.sides[1] = {second, names.of(loop.points[1])};
  cycle.length = names.of(loop.length);
  cycle.length_joint = loop.length_joint;
  if (loop.length_joint) cycle.length = symbolic::symbol(robot.joints[*loop.length_joint].variable);
  return cycle;
}

void check_axis(const model::Loop& loop, const model::Robot& robot, const Cycle& cycle,
                const inverse::Scope& scope) {
  if (!loop.axis || !cycle.normal) return;
  const Carrier at_zero{robot, [&](std::size_t joint) {
                          const bool turns = robot.joints[joint].type == model::JointType::revolute;
                          return inverse::Scope::Turn{turns ? 1 : 0, 0};
                        }};
  const Side& side = cycle.sides[0];
  Vector axis = symbolic::to_symbolic(*loop.axis);
  if (!side.joints.empty()) {
    const model::Joint& last = robot.joints[side.joints.back()];
    axis = symbolic::rotate(symbolic::to_symbolic(last.after).q, axis);
    axis = at_zero.lifted_direction(side, static_cast<int>(side.joints.size()) - 1, axis, -1);
  }
  if (!scope.is_zero(cross(axis, *cycle.normal)))
    throw std::domain_error(
        "loop " + std::to_string(cycle.number) +
        ": the pin's axis is not parallel to the axes of the loop's joints, so that nothing "
        "moves; correct `axis`, or make it a ball");
}

}  // namespace

std::vector<std::size_t> Cycle::joints() const {
  std::vector<std::size_t> all = sides[0].joints;
  all.insert(all.end(), sides[1].joints.begin(), sides[1].joints.end());
  if (length_joint) all.push_back(*length_joint);
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Cycle> cycles_of(const model::Mechanism& mechanism, const model::Robot& robot,
                             const inverse::Scope& scope) {
  const PrivateNames names(mechanism.robot);
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i < mechanism.loops.closures.size(); ++i) {
    cycles.push_back(cycle_of(mechanism, robot, i, names));
    cycles.back().normal = normal_of(robot, cycles.back(), scope);
    check_axis(mechanism.loops.closures[i], robot, cycles.back(), scope);
  }
  return cycles;
}

Vector Carrier::moved(std::size_t index, const Vector& x, bool back, bool is_direction) const {
  const model::Joint& joint = robot.joints[index];
  const inverse::Scope::Turn by = value(index);
  const Vector axis = symbolic::to_symbolic(joint.axis);
  if (joint.type == model::JointType::prismatic)
    return is_direction ? x : x + (back ? -by.cosine : by.cosine) * axis;
  const ex along = dot(axis, x);
  const ex sine = back ? -by.sine : by.sine;
  // In the axis' plane and along it, so that coordinates along a coordinate axis stay as they are.
  const Vector across = x - along * axis;
  const Vector turned = by.cosine * across + sine * cross(axis, x) + along * axis;
  return name ? name(turned) : turned;
}

Vector Carrier::lifted(const Side& side, int from, const Vector& x, int to) const {
  const auto joint = [&](int i) -> const model::Joint& {
    return robot.joints[side.joints[static_cast<std::size_t>(i)]];
  };
  Vector v = symbolic::to_symbolic(joint(from).before) * x;
  for (int i = from - 1; i > to; --i) {
    v = moved(side.joints[static_cast<std::size_t>(i)], symbolic::to_symbolic(joint(i).after) * v, false,
              false);
    v = symbolic::to_symbolic(joint(i).before) * v;
  }
  return to < 0 ? v : symbolic::to_symbolic(joint(to).after) * v;
}

Vector Carrier::lifted_direction(const Side& side, int from, const Vector& d, int to) const {
  const auto joint = [&](int i) -> const model::Joint& {
    return robot.joints[side.joints[static_cast<std::size_t>(i)]];
  };
  Vector v = symbolic::rotate(symbolic::to_symbolic(joint(from).before).q, d);
  for (int i = from - 1; i > to; --i) {
    v = symbolic::rotate(symbolic::to_symbolic(joint(i).after).q, v);
    v = moved(side.joints[static_cast<std::size_t>(i)], v, false, true);
    v = symbolic::rotate(symbolic::to_symbolic(joint(i).before).q, v);
  }
  return to < 0 ? v : symbolic::rotate(symbolic::to_symbolic(joint(to).after).q, v);
}

Vector Carrier::lowered(const Side& side, int from, const Vector& x, int to) const {
  const auto joint = [&](int i) -> const model::Joint& {
    return robot.joints[side.joints[static_cast<std::size_t>(i)]];
  };
  Vector v = from < 0 ? x : symbolic::inverse(symbolic::to_symbolic(joint(from).after)) * x;
  for (int i = from + 1; i < to; ++i) {
    v = symbolic::inverse(symbolic::to_symbolic(joint(i).before)) * v;
    v = moved(side.joints[static_cast<std::size_t>(i)], v, true, false);
    v = symbolic::inverse(symbolic::to_symbolic(joint(i).after)) * v;
  }
  return symbolic::inverse(symbolic::to_symbolic(joint(to).before)) * v;
}

Vector Carrier::lowered_direction(const Side& side, int from, const Vector& d, int to) const {
  const auto joint = [&](int i) -> const model::Joint& {
    return robot.joints[side.joints[static_cast<std::size_t>(i)]];
  };
  const auto back = [](const model::Displacement& displacement, const Vector& x) {
    return symbolic::rotate(symbolic::inverse(symbolic::to_symbolic(displacement).q), x);
  };
  Vector v = from < 0 ? d : back(joint(from).after, d);
  for (int i = from + 1; i < to; ++i) {
    v = moved(side.joints[static_cast<std::size_t>(i)], back(joint(i).before, v), true, true);
    v = back(joint(i).after, v);
  }
  return back(joint(to).before, v);
}

Vector Carrier::end(const Side& side, int to) const {
  if (side.joints.empty()) return side.point;
  const int last = static_cast<int>(side.joints.size()) - 1;
  const std::size_t joint = side.joints.back();
  const Vector x = symbolic::to_symbolic(robot.joints[joint].after) * side.point;
  return last == to ? x : lifted(side, last, moved(joint, x, false, false), to);
}

}  // namespace qvgen::derive::loops
