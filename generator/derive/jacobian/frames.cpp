// SPDX-License-Identifier: MIT
#include "derive/jacobian/frames.h"

#include "derive/kinematics/turns.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

Moving operator+(const Moving& a, const Moving& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
Moving operator*(const ex& s, const Moving& v) { return {s * v.value, s * v.rate, s * v.second}; }

Frames::Frames(Program& program, const Linkage& linkage, const RateOf& rate_of)
    : program_(program),
      linkage_(linkage),
      rate_of_(rate_of ? rate_of : RateOf([](std::size_t) { return ex(0); })),
      columns_(linkage.variables.size()),
      behind_(linkage.variables.size()) {
  group_pivots();
  reach();
}

void Frames::group_pivots() {
  for (const Linkage::Pivot& pivot : linkage_.pivots) {
    const int sign = groups_.empty() ? 0 : parallel(groups_.back().axis, pivot.axis);
    if (sign == 0) {
      groups_.push_back({pivot.axis});
      if (!places_.empty()) places_.back().ends_group = true;
    }
    Group& group = groups_.back();
    const int direction = sign == 0 ? 1 : sign;
    group.angle += direction * pivot.angle;
    if (pivot.joint >= 0) group.rate += direction * rate_of_(static_cast<std::size_t>(pivot.joint));
    places_.push_back({groups_.size() - 1, group.angle, group.rate, false});
  }
  if (!places_.empty()) places_.back().ends_group = true;
}

/// From the tool to the base: the vector from each pivot to the tool, in front of the pivot's group and
/// behind it.
void Frames::reach() {
  Moving front = travelled(linkage_.beyond);
  Moving back;
  for (std::size_t i = linkage_.pivots.size(); i-- > 0;) {
    const Place& place = places_[i];
    const Linkage::Way& way =
        i + 1 < linkage_.pivots.size() ? linkage_.pivots[i + 1].before : linkage_.beyond;
    add_slides(way, static_cast<int>(i));
    const Group& group = groups_[place.group];
    // Behind a group's last pivot the vector is given in the frame there; else it is in front of the group
    // already.
    if (place.ends_group) {
      back = front;
      front = turned(group.axis, place.angle, place.rate, front);
    } else {
      front = name(turned(group.axis, place.angle, place.rate, travelled(way)) + front);
      back =
          name(turned(group.axis, place.angle - group.angle, place.rate - group.rate, travelled(way)) + back);
    }
    if (linkage_.pivots[i].joint >= 0) add_column(i, front, back);
    const bool starts_group = i == 0 || places_[i - 1].ends_group;
    if (starts_group) front = name(front + travelled(linkage_.pivots[i].before));
  }
  add_slides(linkage_.pivots.empty() ? linkage_.beyond : linkage_.pivots.front().before, -1);
  position_ = front;
}

void Frames::add_column(std::size_t pivot, const Moving& front, const Moving& back) {
  const Linkage::Pivot& at = linkage_.pivots[pivot];
  const Place& place = places_[pivot];
  const auto twist = [&](const Moving& u) {
    return MovingTwist{name({cross(at.axis, u.value), cross(at.axis, u.rate), {}}), {at.axis, {}, {}}};
  };
  columns_[static_cast<std::size_t>(at.joint)] = {place.group, twist(front), front.value};
  behind_[static_cast<std::size_t>(at.joint)] = {place.group + 1, twist(back), back.value};
}

void Frames::add_slides(const Linkage::Way& way, int pivot) {
  for (const Linkage::Slide& slide : way.slides) {
    Column& column = columns_[slide.joint];
    column.twist.linear = {slide.axis, {}, {}};
    behind_[slide.joint] = column;
    if (pivot < 0) continue;
    const Place& place = places_[static_cast<std::size_t>(pivot)];
    const Group& group = groups_[place.group];
    column.frame = behind_[slide.joint].frame = place.group + 1;
    if (place.ends_group) continue;
    column = {place.group, {turned(group.axis, place.angle, place.rate, {slide.axis, {}, {}}), {}}, {}};
    behind_[slide.joint].twist.linear =
        turned(group.axis, place.angle - group.angle, place.rate - group.rate, {slide.axis, {}, {}});
  }
}

Moving Frames::travelled(const Linkage::Way& way) const {
  Moving result{way.offset, {}, {}};
  for (const Linkage::Slide& slide : way.slides) {
    result.value = result.value + linkage_.variables[slide.joint] * slide.axis;
    result.rate = result.rate + rate_of_(slide.joint) * slide.axis;
  }
  return result;
}

Moving Frames::name(const Moving& v) {
  return {program_.let(v.value), program_.let(v.rate), program_.let(v.second)};
}

/// With w = R v: w' = R v' + rate axis x w, w'' = R v'' + rate axis x (R v' + w').
Moving Frames::turned(const Vector& axis, const ex& angle, const ex& rate, const Moving& v) {
  const Turn turn{axis, angle};
  const Vector value = program_.let(derive::turned(turn, v.value));
  const Vector change = program_.let(derive::turned(turn, v.rate));
  const Vector first = program_.let(change + rate * program_.let(cross(axis, value)));
  const Vector second = program_.let(derive::turned(turn, v.second));
  return {value, first,
          program_.let(second + rate * program_.let(cross(axis, program_.let(change + first))))};
}

Moving Frames::move(Moving v, std::size_t from, std::size_t to) {
  for (; from > to; --from)
    v = turned(groups_[from - 1].axis, groups_[from - 1].angle, groups_[from - 1].rate, v);
  for (; from < to; ++from) v = turned(groups_[from].axis, -groups_[from].angle, -groups_[from].rate, v);
  return v;
}

MovingTwist Frames::move(const MovingTwist& twist, std::size_t from, std::size_t to) {
  return {move(twist.linear, from, to), move(twist.angular, from, to)};
}

Vector Frames::brought(std::size_t pivots, const Vector& v, std::size_t to) {
  if (pivots == 0) return move(Moving{v, {}, {}}, 0, to).value;
  const Place& place = places_[pivots - 1];
  if (place.ends_group) return move(Moving{v, {}, {}}, place.group + 1, to).value;
  const Group& group = groups_[place.group];
  // Behind the group or in front of it, whichever is nearer.
  if (to > place.group)
    return move(turned(group.axis, place.angle - group.angle, 0, {v, {}, {}}), place.group + 1, to).value;
  return move(turned(group.axis, place.angle, 0, {v, {}, {}}), place.group, to).value;
}

MovingTwist Frames::to_tool(const MovingTwist& twist) {
  const Quaternion back = inverse(linkage_.home);
  const auto turn = [&](const Vector& v) {
    const Vector r = rotate(back, v);
    return program_.let(Vector{r.x.expand(), r.y.expand(), r.z.expand()});
  };
  const auto both = [&](const Moving& v) { return Moving{turn(v.value), turn(v.rate), turn(v.second)}; };
  return {both(twist.linear), both(twist.angular)};
}

}  // namespace qvgen::derive
