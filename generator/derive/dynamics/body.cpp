// SPDX-License-Identifier: MIT
#include "derive/dynamics/body.h"

namespace qvgen::derive::dynamics {

Matrix3 u_matrix(const Vector3& w, const Scalar& u13, const Scalar& u23, const Scalar& wz_rate,
                 Suggestions& suggest) {
  const Scalar xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  const Scalar xy = w[0] * w[1], xz = w[0] * w[2], yz = w[1] * w[2];
  Matrix3 u;
  u[0] = {-(yy + zz), xy - wz_rate, u13};
  u[1] = {xy + wz_rate, -(xx + zz), u23};
  const Scalar wy_rate = u13 - xz, wx_rate = yz - u23;
  u[2] = {xz - wy_rate, yz + wx_rate, -(xx + yy)};
  // The diagonal follows from U33 as well, which a joint's rotation about z leaves alone; and doubles of
  // products.
  suggest({-u[2][2] - xx, -u[2][2] - yy, u[2][2] + (xx - zz), u[2][2] + (yy - zz)});
  suggest({(xz + xz) - u13, (yz + yz) - u23});
  return u;
}

Wrench link_wrench(const PseudoInertia& p, const Matrix3& u, const Vector3& v, Suggestions& suggest) {
  const Vector3 h = p.first_moments();
  Wrench result;
  for (std::size_t r = 0; r < 3; ++r)
    result.force[r] = (u[r][0] * h[0] + u[r][1] * h[1]) + u[r][2] * h[2] + p.mass() * v[r];
  const auto s = [&](std::size_t i, std::size_t k) { return p.at(i, k); };
  const Scalar n1 = u[2][0] * s(0, 1) + u[2][1] * s(1, 1);
  const Scalar n2 = u[2][0] * s(0, 0) + u[2][1] * s(0, 1);
  const Scalar x = n1 + (u[2][2] - u[1][1]) * s(1, 2) - u[1][0] * s(0, 2) - u[1][2] * s(2, 2);
  const Scalar y = (u[0][0] - u[2][2]) * s(0, 2) + u[0][1] * s(1, 2) - n2 + u[0][2] * s(2, 2);
  const Scalar z = ((u[1][1] - u[0][0]) * s(0, 1) + (u[1][0] * s(0, 0) - u[0][1] * s(1, 1))) +
                   (u[1][2] * s(0, 2) - u[0][2] * s(1, 2));
  result.moment = Vector3{x, y, z} + cross(h, v);
  suggest(result.force);
  return result;
}

}  // namespace qvgen::derive::dynamics
