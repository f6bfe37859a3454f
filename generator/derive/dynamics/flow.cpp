// SPDX-License-Identifier: MIT
#include "derive/dynamics/flow.h"

namespace qvgen::derive::dynamics {

namespace {

std::array<Scalar, 4> column(const PseudoInertia& p, std::size_t k) {
  return {p.at(0, k), p.at(1, k), p.at(2, k), p.at(3, k)};
}

Flow rotated(const Flow& flow, std::size_t axis, const Circle& by) {
  Flow half;
  for (std::size_t r = 0; r < 4; ++r) half[r] = rotate(axis, by, flow[r]);
  Flow result = half;
  for (std::size_t a = 0; a < 3; ++a) {
    const Vector3 turned = rotate(axis, by, {half[0][a], half[1][a], half[2][a]});
    for (std::size_t r = 0; r < 3; ++r) result[r][a] = turned[r];
  }
  return result;
}

Flow shifted(const Flow& flow, const Vector3& t) {
  Flow result = flow;
  for (std::size_t r = 0; r < 3; ++r) result[r] = flow[r] + t[r] * flow[3];
  return result;
}

}  // namespace

Flow with_own_motion(Flow flow, const Link& link, const PseudoInertia& composite, const Scalar& rate) {
  const bool slides = link.motion == Motion::prismatic;
  const auto x = column(composite, 0), y = column(composite, 1), mass = column(composite, 3);
  for (std::size_t r = 0; r < 4; ++r) {
    if (slides) {
      flow[r][2] = flow[r][2] + rate * mass[r];
    } else {
      flow[r][0] = flow[r][0] - rate * y[r];
      flow[r][1] = flow[r][1] + rate * x[r];
    }
  }
  return flow;
}

Flow sum(const Flow& a, const Flow& b) {
  Flow result;
  for (std::size_t r = 0; r < 4; ++r) result[r] = a[r] + b[r];
  return result;
}

PseudoInertia rate_of_inertia(const Flow& flow) {
  PseudoInertia rate;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = r; k < 3; ++k) rate.at(r, k) = flow[r][k] + flow[k][r];
    rate.at(r, 3) = flow[3][r];
  }
  return rate;
}

Flow carried(const InwardRecursion& inward, const Link& link, const Flow& flow, dag::Graph& graph) {
  const Vector3 along = {Scalar(), Scalar(), inward.shift_of(link)};
  const Flow turned =
      rotated(rotated(shifted(flow, along), 2, circle(link.angle, graph)), 0, circle(link.alpha, graph));
  return shifted(turned, {link.a, link.b, Scalar()});
}

Wrench wrench_of(const Flow& f) { return {f[3], {f[1][2] - f[2][1], f[2][0] - f[0][2], f[0][1] - f[1][0]}}; }

Wrench coriolis_wrench(const Way& way, const PseudoInertia& composite, const Flow& flow, const Vector3& w) {
  const std::size_t k = way.axis, i = (k + 1) % 3, j = (k + 2) % 3;
  const auto x = column(composite, i), y = column(composite, j), mass = column(composite, 3);
  Flow g;
  for (std::size_t r = 0; r < 4; ++r) {
    g[r][i] = way.slides ? w[j] * mass[r] : -(w[k] * x[r]) - flow[r][j];
    g[r][j] = way.slides ? -(w[i] * mass[r]) : flow[r][i] - w[k] * y[r];
    if (!way.slides) g[r][k] = w[i] * x[r] + w[j] * y[r];
  }
  return wrench_of(g);
}

}  // namespace qvgen::derive::dynamics
