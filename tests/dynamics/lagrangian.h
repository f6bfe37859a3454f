// SPDX-License-Identifier: MIT
// Kinetic energy less potential energy of a tree of links, for any scalar: duals, whose derivatives are
// automatic, or floats of sixty digits. A link's energy is that of its own motion; bodies exert no forces
// here.
#pragma once

#include <array>
#include <vector>

#include "reference/chain.h"

namespace lagrange {

template <class S>
using Vector = std::array<S, 3>;
template <class S>
using Matrix = std::array<Vector<S>, 3>;  ///< rows

template <class S>
Vector<S> operator+(const Vector<S>& a, const Vector<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class S>
Vector<S> operator*(const S& s, const Vector<S>& v) {
  return {s * v[0], s * v[1], s * v[2]};
}
template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Vector<S> cross(const Vector<S>& a, const Vector<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class S>
Vector<S> operator*(const Matrix<S>& m, const Vector<S>& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
template <class S>
Matrix<S> transposed(const Matrix<S>& m) {
  Matrix<S> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {m[0][i], m[1][i], m[2][i]};
  return result;
}
template <class S>
Matrix<S> operator*(const Matrix<S>& a, const Matrix<S>& b) {
  const Matrix<S> columns = transposed(b);
  return transposed(Matrix<S>{a * columns[0], a * columns[1], a * columns[2]});
}

template <class S>
Vector<S> vector(const Eigen::Vector3d& v) {
  return {S(v.x()), S(v.y()), S(v.z())};
}
template <class S>
Matrix<S> matrix(const Eigen::Matrix3d& m) {
  return {vector<S>(m.row(0)), vector<S>(m.row(1)), vector<S>(m.row(2))};
}

/// Rodrigues.
template <class S>
Matrix<S> rotation(const Eigen::Vector3d& axis, const S& angle) {
  const Vector<S> a = vector<S>(axis);
  const S c = cos(angle), s = sin(angle);
  Matrix<S> columns;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector<S> e = {S(0.0), S(0.0), S(0.0)};
    e[k] = S(1.0);
    columns[k] = c * e + s * cross(a, e) + ((S(1.0) - c) * a[k]) * a;
  }
  return transposed(columns);
}

/// Pose and motion of a body, in the world.
template <class S>
struct Body {
  Matrix<S> rotation;
  Vector<S> position, angular_velocity, velocity;

  /// To another of its points, given in the body's frame.
  void move(const Vector<S>& offset) {
    const Vector<S> lever = rotation * offset;
    velocity = velocity + cross(angular_velocity, lever);
    position = position + lever;
  }
  /// Over a joint, to the frame of its link.
  void cross_joint(const reference::Joint& joint, const S& q, const S& qd) {
    move(vector<S>(joint.before.translation()));
    rotation = rotation * matrix<S>(joint.before.linear());
    const Vector<S> axis = rotation * vector<S>(joint.axis);
    if (joint.revolute) {
      angular_velocity = angular_velocity + qd * axis;
      rotation = rotation * lagrange::rotation<S>(joint.axis, q);
    } else {
      move(q * vector<S>(joint.axis));
      velocity = velocity + qd * axis;
    }
    move(vector<S>(joint.after.translation()));
    rotation = rotation * matrix<S>(joint.after.linear());
  }
};

template <class S>
S kinetic_minus_potential(const reference::Joint& link, Body<S> body, const Eigen::Vector3d& gravity) {
  const Vector<S> local = transposed(body.rotation) * body.angular_velocity;
  body.move(vector<S>(link.centre_of_mass));
  return S(0.5) * dot(local, matrix<S>(link.inertia) * local) +
         S(link.mass) * (S(0.5) * dot(body.velocity, body.velocity) + dot(vector<S>(gravity), body.position));
}

/// The value of joint i of the chain by those of the joints that have one of their own.
template <class S>
S value_of(const Eigen::MatrixXd& coupling, Eigen::Index i, const std::vector<S>& values) {
  S sum(0.0);
  for (Eigen::Index k = 0; k < coupling.cols(); ++k)
    sum = sum + S(coupling(i, k)) * values[static_cast<std::size_t>(k)];
  return sum;
}

template <class S>
S lagrangian(const reference::Chain& chain, const std::vector<S>& q, const std::vector<S>& qd,
             const Eigen::Vector3d& gravity) {
  const Vector<S> none = vector<S>(Eigen::Vector3d(0, 0, 0));
  const Body<S> base{matrix<S>(chain.base.linear()), vector<S>(chain.base.translation()), none, none};
  std::vector<Body<S>> links;
  const Eigen::MatrixXd coupling = chain.coupling();
  S sum(0.0);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::Index parent = chain.parent_of(i);
    Body<S> body = parent < 0 ? base : links[static_cast<std::size_t>(parent)];
    body.cross_joint(chain.joints[i], value_of(coupling, row, q), value_of(coupling, row, qd));
    links.push_back(body);
    sum = sum + kinetic_minus_potential(chain.joints[i], body, gravity);
  }
  return sum;
}

}  // namespace lagrange
