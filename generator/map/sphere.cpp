// SPDX-License-Identifier: MIT
#include "map/sphere.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace qvgen::map {
namespace {

using report::Vector;

/// A point that may be moved along an axis; of the tool it may not.
struct Stop {
  Vector point;
  Vector axis = Vector::Zero();
};

/// Returns the point of a line over which the way from `before` to `after` is shortest, as light goes.
Vector shortest(const Stop& line, const Vector& before, const Vector& after) {
  const double first = (before - line.point).dot(line.axis), last = (after - line.point).dot(line.axis);
  const double first_off = (before - line.point - first * line.axis).norm();
  const double last_off = (after - line.point - last * line.axis).norm();
  const double off = first_off + last_off;
  const double place = off > 0 ? first + (last - first) * first_off / off : 0.5 * (first + last);
  return line.point + place * line.axis;
}

/// Moves the points along their axes until the way over all of them is shortest; it has one minimum.
void pull_tight(std::vector<Stop>& stops) {
  constexpr int rounds = 1000;  // each is a few operations
  for (int round = 0; round < rounds; ++round) {
    Stop& first = stops.front();  // nothing goes before it: the foot of the next
    first.point += (stops[1].point - first.point).dot(first.axis) * first.axis;
    for (std::size_t i = 1; i + 1 < stops.size(); ++i)
      stops[i].point = shortest(stops[i], stops[i - 1].point, stops[i + 1].point);
  }
}

void refuse_endless(const report::Chain& chain) {
  for (const report::ChainJoint& joint : chain.joints)
    if (!joint.revolute &&
        !(joint.limits && std::isfinite(joint.limits->first) && std::isfinite(joint.limits->second)))
      throw std::runtime_error(
          joint.variable +
          " slides without limits, so that there is no end to the arm's reach: write its "
          "limits into the description, or say with --reach how far to look, in metres");
}

}  // namespace

Sphere sphere_of(const report::Chain& chain, std::optional<double> radius) {
  if (!radius) refuse_endless(chain);
  const report::Posture zero = report::posture_of(chain, std::vector<double>(chain.joints.size()));
  std::vector<Stop> stops;
  double travel = 0;
  Vector shift = Vector::Zero();  // of slides before all turns, to the middle of their travel
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const report::ChainJoint& joint = chain.joints[i];
    const auto [lower, upper] = report::range_of(chain, i);
    if (joint.revolute) {
      stops.push_back({zero.joints[i].point, zero.joints[i].axis});
    } else if (stops.empty()) {
      shift += 0.5 * (lower + upper) * zero.joints[i].axis;
      travel += 0.5 * (upper - lower);
    } else {
      travel += std::max(std::abs(lower), std::abs(upper));
    }
  }
  stops.push_back({zero.tool.translation()});
  if (stops.size() > 1) pull_tight(stops);
  double length = travel;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) length += (stops[i + 1].point - stops[i].point).norm();
  const Vector centre = stops.front().point + shift;
  // A zero that rounding has moved would be seen in file names and labels.
  const auto clean = [](double value) { return std::abs(value) < 1e-12 ? 0.0 : value; };
  return {{clean(centre[0]), clean(centre[1]), clean(centre[2])}, radius.value_or(length * (1 + 1e-9)), 0};
}

}  // namespace qvgen::map
