// SPDX-License-Identifier: MIT
#include "derive/inverse/exchange.h"

#include <algorithm>

#include "derive/inverse/attempt.h"
#include "model/arithmetic.h"

namespace qvgen::derive::inverse {

using model::Joint;
using symbolic::cross;
using symbolic::dot;

namespace {

model::Vector3 with_sign(const model::Vector3& axis, bool same_way) {
  model::Vector3 result = axis;
  for (model::Expression& part : result)
    if (!same_way) part = model::negate(part);
  return result;
}

/// Puts the slide b in front of the turn a, or the turn b in front of the slide a. The turn's axis then gives
/// the slide's direction, for the displacement between the joints is on the turn's other side.
void exchange(Joint& a, Joint& b, bool same_way) {
  Joint first = b, second = a;
  const model::Displacement between = model::compose(a.after, b.before);
  if (a.type == model::JointType::revolute) {
    first.before = a.before;
    first.axis = with_sign(a.axis, same_way);
    second.after = model::compose(between, b.after);
  } else {
    first.before = model::compose(a.before, between);
    second.axis = with_sign(b.axis, same_way);
    second.after = b.after;
  }
  first.after = second.before = {};
  a = first;
  b = second;
}

/// The problems that one exchange leads to.
std::vector<Problem> after_one_exchange(const Problem& problem) {
  std::vector<Problem> result;
  const Attempt attempt(problem);
  const auto& screws = attempt.chain.screws;
  for (std::size_t k = 0; k + 1 < screws.size(); ++k) {
    const Screw &a = screws[k], &b = screws[k + 1];
    if (a.revolute == b.revolute || !attempt.scope.is_zero(cross(a.axis, b.axis))) continue;
    Problem next = problem;
    exchange(next.robot.joints[k], next.robot.joints[k + 1], attempt.scope.sample(dot(a.axis, b.axis)) > 0);
    std::swap(next.places[k], next.places[k + 1]);
    result.push_back(std::move(next));
  }
  return result;
}

}  // namespace

std::vector<Problem> in_other_orders(const Problem& problem) {
  if (problem.given >= 0) return {};
  constexpr std::size_t most = 12;
  std::vector<Problem> orders{problem};
  for (std::size_t i = 0; i < orders.size() && orders.size() < most; ++i)
    for (Problem& next : after_one_exchange(Problem(orders[i]))) {
      const bool is_known = std::any_of(orders.begin(), orders.end(),
                                        [&](const Problem& order) { return order.places == next.places; });
      if (!is_known) orders.push_back(std::move(next));
    }
  orders.erase(orders.begin());
  return orders;
}

}  // namespace qvgen::derive::inverse
