// SPDX-License-Identifier: MIT
#include "report/dh.h"

#include <cmath>

namespace qvgen::report {
namespace {

constexpr double parallel = 1e-9;

struct Line {
  Vector point, axis;
};

/// The feet of the common normal of two lines: on the first and on the second. Of parallel ones the normal
/// through `origin`, a point of the first.
std::pair<Vector, Vector> feet(const Line& first, const Line& second, const Vector& origin) {
  const Vector normal = first.axis.cross(second.axis);
  const double square = normal.squaredNorm();
  if (square < parallel * parallel) {
    const Vector between = second.point - origin;
    return {origin, second.point - between.dot(first.axis) * first.axis};
  }
  const Vector between = second.point - first.point;
  const double s = between.cross(second.axis).dot(normal) / square;
  const double t = between.cross(first.axis).dot(normal) / square;
  return {first.point + s * first.axis, second.point + t * second.axis};
}

double angle_about(const Vector& axis, const Vector& from, const Vector& to) {
  const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
  return std::abs(angle) < 1e-12 ? 0 : angle;
}

double rounded(double value) { return std::abs(value) < 1e-12 ? 0 : value; }

/// The direction of the x axis behind a joint.
Vector direction(const Line& first, const Line& second, const Vector& from, const Vector& to,
                 const Vector& x) {
  if ((to - from).norm() > 1e-9) return (to - from).normalized();
  const Vector normal = first.axis.cross(second.axis);
  if (normal.norm() < parallel) return x;
  // One of two ways leaves the joint's zero where it is, as far as it can: that one.
  const Vector candidate = normal.normalized();
  return candidate.dot(x) < -1e-9 ? Vector(-candidate) : candidate;
}

}  // namespace

DhTable dh_table(const Chain& chain) {
  const std::size_t count = chain.joints.size();
  const Posture posture = posture_of(chain, std::vector<double>(count));
  std::vector<Line> lines;
  for (const auto& joint : posture.joints) lines.push_back({joint.point, joint.axis});
  DhTable table;
  Vector origin = lines.front().point;
  Vector x = normal_to(lines.front().axis);
  table.base = frame(x, lines.front().axis, origin);
  Motion last = table.base;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count;
    const Line& line = lines[i];
    const Line& next = is_last ? line : lines[i + 1];
    const auto [from, to] = is_last ? std::pair(line.point, line.point) : feet(line, next, origin);
    const Vector next_x = direction(line, next, from, to, x);
    table.rows.push_back({angle_about(line.axis, x, next_x), rounded((from - origin).dot(line.axis)),
                          rounded((to - from).dot(next_x)), angle_about(next_x, line.axis, next.axis)});
    x = next_x;
    origin = to;
    last = frame(x, next.axis, origin);
  }
  table.tool = last.inverse() * posture.tool;
  return table;
}

}  // namespace qvgen::report
