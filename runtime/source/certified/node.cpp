// SPDX-License-Identifier: MIT
#include "node.h"

namespace qvgen::inverse::certified {
namespace {

constexpr double farthest = 1e-6;  ///< of a node's box from its joints
constexpr double widest = 0.5;     ///< of a stretch's box

bool are_narrow(const double (&radius)[joints]) {
  for (const double each : radius)
    if (!(each < widest)) return false;
  return true;
}

bool holds(const TubeBox& box, const Node& node) {
  for (int k = 0; k < joints; ++k)
    if (!is_inside(node.box.solution[k], around(box.middle[k], box.radius[k]))) return false;
  return true;
}

}  // namespace

Node node_at(const Loop& loop, const double (&q)[joints]) {
  Node node;
  std::copy(q, q + joints, node.q);
  const Row row(loop, node.q);
  if (!row.is_moderate()) return node;
  for (double radius = std::max(2 * row.step(), 1e-15); radius < farthest && !node.proven; radius *= 8)
    node.proven = row.has_one_within(radius, node.box);
  return node;
}

bool settle(const Loop& loop, double (&q)[joints]) {
  constexpr double longest = 0.5, settled = 1e-10;
  for (int i = 0; i < 8; ++i) {
    const Row row(loop, q);
    if (!row.is_moderate() || !(row.step() < longest)) return false;
    for (int k = 0; k < joints; ++k) q[k] += row.step(k);
    if (row.step() < settled) return true;
  }
  return false;
}

bool has_one_motion(const Loop& stretch, const Node& from, const Node& to, TubeBox& box) {
  for (int k = 0; k < joints; ++k) box.middle[k] = 0.5 * (from.q[k] + to.q[k]);
  const Row row(stretch, box.middle);
  if (!row.is_moderate()) return false;
  for (int k = 0; k < joints; ++k)
    box.radius[k] = 1.2 * std::max(row.reach(k), 0.5 * std::abs(to.q[k] - from.q[k])) + 1e-9;
  for (int trial = 0; trial < 4 && are_narrow(box.radius); ++trial) {
    if (row.has_one_within(box.radius, box.solution)) return holds(box, from) && holds(box, to);
    for (int k = 0; k < joints; ++k)
      box.radius[k] =
          1.2 * std::max(box.radius[k], (box.solution.solution[k] - Interval(box.middle[k])).magnitude());
  }
  return false;
}

}  // namespace qvgen::inverse::certified
