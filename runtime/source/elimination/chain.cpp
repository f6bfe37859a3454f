// SPDX-License-Identifier: MIT
#include <cmath>

#include <Eigen/Geometry>
#include <qvgen/inverse/elimination/setup.h>

namespace qvgen::inverse::elimination {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d vector_of(const Triple<double>& v) { return {v[0], v[1], v[2]}; }

Isometry3d isometry_of(const Motion& motion) {
  Isometry3d result = Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.linear()(i, k) = motion.rotation[3 * i + k];
    result.translation()[i] = motion.translation[i];
  }
  return result;
}

Motion motion_of(const Isometry3d& isometry) {
  Motion result;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.rotation[3 * i + k] = isometry.linear()(i, k);
    result.translation[i] = isometry.translation()[i];
  }
  return result;
}

/// A unit vector at right angles to an axis: along the common normal with the next one where they are not
/// nearly parallel.
Vector3d across(const Vector3d& axis, const Vector3d& next) {
  constexpr double nearly_parallel = 1e-3;
  const Vector3d normal = axis.cross(next);
  if (normal.norm() > nearly_parallel) return normal.normalized();
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vector3d::Unit(least)).normalized();
}

/// A frame on each axis, its origin where the next one's is nearest: the links are short then.
void frames_of(const Description& arm, Isometry3d (&frames)[joints + 1]) {
  frames[joints] = isometry_of(arm.tool);
  for (int i = joints - 1; i >= 0; --i) {
    const Screw<double>& screw = arm.axes[i];
    const Vector3d axis = vector_of(screw.axis).normalized();
    const Vector3d point = vector_of(screw.point);
    const Vector3d next = frames[i + 1].translation();
    const Vector3d x = across(axis, frames[i + 1].linear().col(2));
    frames[i].setIdentity();
    frames[i].linear() << x, axis.cross(x), axis;
    frames[i].translation() = screw.revolute ? Vector3d(point + axis * axis.dot(next - point)) : next;
  }
}

}  // namespace

Chain chain_of(const Description& arm) {
  Isometry3d frames[joints + 1];
  frames_of(arm, frames);
  Chain chain;
  chain.to_base = motion_of(frames[0].inverse());
  double links = 0;
  chain.reach = frames[0].translation().norm();
  for (int i = 0; i < joints; ++i) {
    const Isometry3d link = frames[i].inverse() * frames[i + 1];
    chain.links[i] = motion_of(link);
    chain.slides[i] = !arm.axes[i].revolute;
    if (i + 1 < joints) links += link.translation().norm();
    chain.reach += chain.slides[i] ? 1e50 : link.translation().norm();
  }
  chain.size = links / 4;
  return chain;
}

Setup with_last_axis(const Setup& setup, const Triple<double>& axis) {
  constexpr int last = joints - 1;
  Setup result = setup;
  Chain& chain = result.chain;
  const Isometry3d to_tool = isometry_of(chain.links[last - 1]) * isometry_of(chain.links[last]);
  const Vector3d z = vector_of(axis).normalized(), x = z.unitOrthogonal();
  Isometry3d in_tool = Isometry3d::Identity();
  in_tool.linear() << x, z.cross(x), z;
  const Isometry3d link = to_tool * in_tool;
  chain.links[last - 1] = motion_of(link);
  chain.links[last] = motion_of(in_tool.inverse());
  const Vector3d at_zero = isometry_of(setup.description.tool).linear() * z;
  for (int i = 0; i < 3; ++i) result.description.axes[last].axis[static_cast<std::size_t>(i)] = at_zero[i];
  for (int k = 0; k < result.count; ++k) {
    Elimination& e = result.eliminations[k];
    Motion& of_loop = e.link[e.backwards ? (joints - e.shift) % joints : last - 1 - e.shift];
    of_loop = e.backwards ? motion_of(link.inverse()) : chain.links[last - 1];
    for (double& t : of_loop.translation) t /= chain.size;
  }
  return result;
}

}  // namespace qvgen::inverse::elimination
