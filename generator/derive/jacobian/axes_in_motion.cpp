// SPDX-License-Identifier: MIT
#include "derive/jacobian/axes_in_motion.h"

#include "derive/kinematics/turns.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

bool is_zero(const Vector& v) {
  return v.x.expand().is_zero() && v.y.expand().is_zero() && v.z.expand().is_zero();
}

Vector expanded(const Vector& v) { return {v.x.expand(), v.y.expand(), v.z.expand()}; }

}  // namespace

AxesInMotion::AxesInMotion(Program& program, const Linkage& linkage, std::size_t frame,
                           const Frames::RateOf& rate_of, Order order)
    : program_(program),
      linkage_(linkage),
      frames_(program, linkage),
      frame_(frame),
      rate_of_(rate_of),
      order_(order) {
  turn_all();
  step_all();
}

const Linkage::Way& AxesInMotion::way(std::size_t pivots) const {
  return pivots < linkage_.pivots.size() ? linkage_.pivots[pivots].before : linkage_.beyond;
}

Moving AxesInMotion::let(const Moving& v) {
  return {program_.let(v.value), program_.let(v.rate), program_.let(v.second)};
}

/// A vector fixed to the link behind the first pivots.
Moving AxesInMotion::fixed(std::size_t pivots, const Vector& v) {
  if (is_zero(v)) return {};
  const Link& link = links_[pivots];
  Moving result;
  result.value = frames_.brought(pivots, v, frame_);
  result.rate = program_.let(cross(link.velocity, result.value));
  if (order_ == Order::second)
    result.second = program_.let(cross(link.velocity, result.rate) + cross(link.acceleration, result.value));
  return result;
}

/// s v, for a number s that changes at a constant rate.
Moving AxesInMotion::scaled(const ex& s, const ex& rate, const Moving& v) const {
  if (order_ == Order::first) return {s * v.value, s * v.rate + rate * v.value, {}};
  return {s * v.value, s * v.rate + rate * v.value, s * v.second + 2 * rate * v.rate};
}

/// Axes first, for they are fixed to the link before as to the link behind.
void AxesInMotion::turn_all() {
  links_.push_back({});
  for (std::size_t k = 0; k < linkage_.pivots.size(); ++k) {
    const Linkage::Pivot& pivot = linkage_.pivots[k];
    const bool as_before = k > 0 && parallel(linkage_.pivots[k - 1].axis, pivot.axis) == 1;
    axes_.push_back(as_before ? axes_.back() : fixed(k, pivot.axis));
    Link link = links_.back();
    if (pivot.joint >= 0) {
      const ex rate = rate_of_(static_cast<std::size_t>(pivot.joint));
      link.velocity = program_.let(link.velocity + rate * axes_.back().value);
      if (order_ == Order::second)
        link.acceleration = program_.let(link.acceleration + rate * axes_.back().rate);
    }
    links_.push_back(link);
  }
}

void AxesInMotion::step_all() {
  for (std::size_t k = 0; k <= linkage_.pivots.size(); ++k) {
    Vector rest = way(k).offset;
    Vector rest_rate;
    for (const Linkage::Slide& slide : way(k).slides) {
      rest = rest + linkage_.variables[slide.joint] * slide.axis;
      rest_rate = rest_rate + rate_of_(slide.joint) * slide.axis;
    }
    const auto take = [&](std::size_t pivot) {
      const Vector& axis = linkage_.pivots[pivot].axis;
      const ex length = dot(rest, axis).expand();
      const ex rate = dot(rest_rate, axis).expand();
      rest = expanded(rest - length * axis);
      rest_rate = expanded(rest_rate - rate * axis);
      return scaled(length, rate, axes_[pivot]);
    };
    Step step;
    if (k > 0) step.along = take(k - 1);
    if (k < axes_.size()) step.across = take(k);
    // The rest changes its length where a joint slides in this direction.
    const Moving still = fixed(k, rest);
    const Moving sliding = fixed(k, rest_rate);
    step.across =
        step.across + Moving{still.value, still.rate + sliding.value, still.second + 2 * sliding.rate};
    steps_.push_back({let(step.along), let(step.across)});
  }
}

Twist AxesInMotion::to_base(const Twist& twist) {
  const auto move = [&](const Vector& v) { return frames_.move(Moving{v, {}, {}}, frame_, 0).value; };
  return {move(twist.linear), move(twist.angular)};
}

std::vector<Twist> AxesInMotion::column_rates() {
  std::vector<Twist> columns(linkage_.variables.size());
  Moving reach;
  for (std::size_t k = linkage_.pivots.size() + 1; k-- > 0;) {
    for (const Linkage::Slide& slide : way(k).slides)
      columns[slide.joint] = to_base({fixed(k, slide.axis).rate, {}});
    reach = let(reach + steps_[k].across);
    if (k == 0) break;
    const Linkage::Pivot& pivot = linkage_.pivots[k - 1];
    const Moving& axis = axes_[k - 1];
    if (pivot.joint >= 0) {
      columns[static_cast<std::size_t>(pivot.joint)] =
          to_base({program_.let(cross(axis.rate, reach.value) + cross(axis.value, reach.rate)), axis.rate});
    }
    reach = let(reach + steps_[k].along);
  }
  return columns;
}

Twist AxesInMotion::acceleration() {
  Moving reach;
  for (std::size_t k = steps_.size(); k-- > 0;) reach = let(reach + steps_[k].across + steps_[k].along);
  return to_base({reach.second, links_.back().acceleration});
}

}  // namespace qvgen::derive
