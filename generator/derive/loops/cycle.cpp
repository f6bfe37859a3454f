// SPDX-License-Identifier: MIT
#include "derive/loops/cycle.h"

#include <algorithm>
#include <stdexcept>

#include "derive/loops/named_angles.h"
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
  cycle.turn = symbolic::to_symbolic(model::Displacement{with_named_angles(loop.turns), {}}).q;
  cycle.length_joint = loop.length_joint;
  if (loop.length_joint) cycle.length = symbolic::symbol(robot.joints[*loop.length_joint].variable);
  return cycle;
}

Carrier carrier_at_zero(const model::Robot& robot) {
  return {robot, [&robot](std::size_t joint) {
            const bool turns = robot.joints[joint].type == model::JointType::revolute;
            return inverse::Scope::Turn{turns ? 1 : 0, 0};
          }};
}

void check_axis(const model::Loop& loop, const model::Robot& robot, const Cycle& cycle,
                const inverse::Scope& scope) {
  if (!loop.axis || !cycle.normal) return;
  const Vector axis =
      carrier_at_zero(robot).end_direction(cycle.sides[0], symbolic::to_symbolic(*loop.axis), -1);
  const std::string name = "loop " + std::to_string(cycle.number);
  if (cycle.type == model::LoopType::slide && !scope.is_zero(dot(axis, *cycle.normal)))
    throw std::domain_error(name +
                            ": the slide's axis is not at right angles to the axes of the loop's joints, so "
                            "that nothing moves; correct `axis`");
  if (cycle.type == model::LoopType::pin && !scope.is_zero(cross(axis, *cycle.normal)))
    throw std::domain_error(name +
                            ": the pin's axis is not parallel to the axes of the loop's joints, so that "
                            "nothing moves; correct `axis`, or make it a ball");
}

/// A direction of the common link, all joints at zero, as each of both last links has it.
std::array<Vector, 2> in_both_links(const model::Robot& robot, const Cycle& cycle, const Vector& direction) {
  std::array<Vector, 2> seen{direction, direction};
  for (std::size_t i = 0; i < 2; ++i) {
    const Side& side = cycle.sides.at(i);
    if (side.joints.empty()) continue;
    const int first = 0;
    const Vector front = carrier_at_zero(robot).lowered_direction(side, -1, direction, first);
    seen.at(i) = carrier_at_zero(robot).at_end(side, first, front, true);
  }
  return seen;
}

/// Adds what both links of a weld or a slide have in common.
void add_directions(const model::Loop& loop, const model::Robot& robot, const inverse::Scope& scope,
                    Cycle& cycle) {
  const bool slides = cycle.type == model::LoopType::slide;
  if (!slides && cycle.type != model::LoopType::weld) return;
  const auto add = [&](const Vector& first) {
    cycle.directions.push_back(
        {scope.clean(first), scope.clean(symbolic::rotate(symbolic::inverse(cycle.turn), first))});
  };
  const Vector axis = slides ? symbolic::to_symbolic(*loop.axis) : Vector{1, 0, 0};
  if (!cycle.normal) {
    add(axis);
    for (const Vector& other : across(axis)) add(other);
    return;
  }
  const std::array<Vector, 2> normal = in_both_links(robot, cycle, *cycle.normal);
  if (!scope.is_zero(symbolic::rotate(cycle.turn, normal[1]) - normal[0]))
    throw std::domain_error("loop " + std::to_string(cycle.number) +
                            ": the links that it ties are turned out of the plane in which its joints move "
                            "them; correct `turns` or `rpy`");
  add(slides ? axis : in_both_links(robot, cycle, across(*cycle.normal)[0])[0]);
}

Cycle cycle_of(const model::Robot& described, const model::Gear& gear, const PrivateNames& names) {
  Cycle cycle;
  cycle.type = model::LoopType::gear;
  cycle.gear = {{gear.joint, 1}};
  for (const auto& [leader, ratio] : gear.leaders) cycle.gear.emplace_back(leader, -ratio);
  cycle.offset = names.of(with_named_number(gear.offset));
  cycle.powers = gear.powers.factors;
  cycle.powers_from = names.of(with_named_number(gear.powers.from));
  const model::Joint& joint = described.joints[gear.joint];
  if (joint.type == model::JointType::prismatic) return cycle;
  if (!model::symbols(gear.offset).empty())
    throw std::domain_error("the angle by which joint " + joint.variable +
                            " is ahead of what it follows is a symbol; write a number");
  cycle.turn = symbolic::to_symbolic(model::Displacement{{turn_by_offset(gear)}, {}}).q;
  return cycle;
}

}  // namespace

std::size_t rows_of(const Cycle& cycle) {
  const bool flat = cycle.normal.has_value();
  switch (cycle.type) {
    case model::LoopType::rod:
    case model::LoopType::gear:
      return 1;
    case model::LoopType::weld:
      return flat ? 3 : 6;
    case model::LoopType::slide:
      return flat ? 2 : 5;
    case model::LoopType::pin:
    case model::LoopType::ball:
      break;
  }
  return flat ? 2 : 3;
}

std::array<Vector, 2> across(const Vector& normal) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (normal.x.is_zero() && normal.y.is_zero()) return {x, y};
  if (normal.y.is_zero() && normal.z.is_zero()) return {y, z};
  if (normal.x.is_zero() && normal.z.is_zero()) return {z, x};
  const Vector& helper = normal.z.is_zero() ? z : normal.x.is_zero() ? x : y;
  const Vector first = cross(normal, helper);
  const Vector unit = ex(1) / GiNaC::sqrt(dot(first, first)) * first;
  return {unit, cross(normal, unit)};
}

std::vector<std::size_t> Cycle::joints() const {
  std::vector<std::size_t> all = sides[0].joints;
  all.insert(all.end(), sides[1].joints.begin(), sides[1].joints.end());
  if (length_joint) all.push_back(*length_joint);
  for (const auto& [joint, factor] : gear) all.push_back(joint);
  std::sort(all.begin(), all.end());
  return all;
}

std::ptrdiff_t equations_with(const std::vector<Cycle>& cycles, std::size_t joint) {
  return std::count_if(cycles.begin(), cycles.end(), [&](const Cycle& each) {
    const auto joints = each.joints();
    return std::find(joints.begin(), joints.end(), joint) != joints.end();
  });
}

std::vector<Cycle> cycles_of(const model::Mechanism& mechanism, const model::Robot& robot,
                             const inverse::Scope& scope) {
  const PrivateNames names(mechanism.robot);
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i < mechanism.loops.closures.size(); ++i) {
    cycles.push_back(cycle_of(mechanism, robot, i, names));
    cycles.back().normal = normal_of(robot, cycles.back(), scope);
    check_axis(mechanism.loops.closures[i], robot, cycles.back(), scope);
    add_directions(mechanism.loops.closures[i], robot, scope, cycles.back());
  }
  for (const model::Gear& gear : mechanism.loops.gears) {
    cycles.push_back(cycle_of(mechanism.robot, gear, names));
    cycles.back().number = cycles.size();
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

Vector Carrier::end_direction(const Side& side, const Vector& d, int to) const {
  if (side.joints.empty()) return d;
  const int last = static_cast<int>(side.joints.size()) - 1;
  const std::size_t joint = side.joints.back();
  const Vector seen = symbolic::rotate(symbolic::to_symbolic(robot.joints[joint].after).q, d);
  return last == to ? seen : lifted_direction(side, last, moved(joint, seen, false, true), to);
}

Vector Carrier::at_end(const Side& side, int from, const Vector& x, bool is_direction) const {
  const int last = static_cast<int>(side.joints.size()) - 1;
  const std::size_t joint = side.joints.back();
  Vector v = x;
  if (from < last) {
    v = is_direction ? lowered_direction(side, from, x, last) : lowered(side, from, x, last);
    v = moved(joint, v, true, is_direction);
  }
  const symbolic::Pair back = symbolic::inverse(symbolic::to_symbolic(robot.joints[joint].after));
  return is_direction ? symbolic::rotate(back.q, v) : back * v;
}

}  // namespace qvgen::derive::loops
