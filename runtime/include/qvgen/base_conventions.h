// SPDX-License-Identifier: MIT
// A floating base in the notations of other libraries. Each is a struct of functions: `position` packs a
// configuration, `configuration` unpacks one, `velocity`, `acceleration` and `force` convert what belongs to
// velocities. Joints are in this robot's own order; permute them where another library orders them otherwise.
//
//                  position                 velocity of the base
//     Pinocchio    x y z, qx qy qz qw       linear, angular, both in the base's frame (as here)
//     MuJoCo       x y z, qw qx qy qz       linear in the world, angular in the base's frame
//     Drake        qw qx qy qz, x y z       angular, linear, both in the world
//     world        -                        linear, angular, both in the world, at the base's origin
#pragma once

#include <qvgen/floating_base.h>

namespace qvgen {

namespace detail {

/// Derivatives of the base's linear velocity in a frame that does not turn: v' + w x v.
template <class Scalar, int size>
Eigen::Matrix<Scalar, size, 1> without_turning(const Eigen::Matrix<Scalar, size, 1>& qd,
                                               Eigen::Matrix<Scalar, size, 1> qdd, Scalar sign) {
  const Vector3<Scalar> v = qd.template head<3>(), w = qd.template segment<3>(3);
  qdd.template head<3>() += sign * w.cross(v);
  return qdd;
}

template <class Scalar, int size>
Eigen::Matrix<Scalar, size, 1> with_halves_exchanged(Eigen::Matrix<Scalar, size, 1> values) {
  const Vector3<Scalar> first = values.template head<3>();
  values.template head<3>() = values.template segment<3>(3);
  values.template segment<3>(3) = first;
  return values;
}

/// Conversions where the base's linear parts are in the world's frame, at the base's origin, and the angular
/// parts in that of the world or of the base.
template <bool turns_angular>
struct LinearInWorld {
  template <class Scalar, int dof>
  using Vector = Eigen::Matrix<Scalar, 6 + dof, 1>;

  template <class Scalar, int dof>
  static Vector<Scalar, dof> velocity(const FloatingConfiguration<Scalar, dof>& at,
                                      const Vector<Scalar, dof>& qd) {
    return turned(at.base.orientation, qd);
  }
  template <class Scalar, int dof>
  static Vector<Scalar, dof> acceleration(const FloatingConfiguration<Scalar, dof>& at,
                                          const Vector<Scalar, dof>& qd, const Vector<Scalar, dof>& qdd) {
    return velocity(at, without_turning<Scalar, 6 + dof>(qd, qdd, Scalar(1)));
  }
  template <class Scalar, int dof>
  static Vector<Scalar, dof> force(const FloatingConfiguration<Scalar, dof>& at,
                                   const Vector<Scalar, dof>& force) {
    return velocity(at, force);
  }
  /// Back to the base's frame: velocities or forces.
  template <class Scalar, int dof>
  static Vector<Scalar, dof> to_base(const FloatingConfiguration<Scalar, dof>& at,
                                     const Vector<Scalar, dof>& values) {
    return turned(at.base.orientation.conjugate(), values);
  }

 private:
  template <class Scalar, int size>
  static Eigen::Matrix<Scalar, size, 1> turned(const Quaternion<Scalar>& by,
                                               Eigen::Matrix<Scalar, size, 1> values) {
    values.template head<3>() = by * values.template head<3>();
    if (turns_angular) values.template segment<3>(3) = by * values.template segment<3>(3);
    return values;
  }
};

}  // namespace detail

/// Velocities, accelerations and forces of the base in the world's frame, at the base's origin.
struct InWorld : detail::LinearInWorld<true> {};

struct Pinocchio {
  template <class Scalar, int dof>
  static Eigen::Matrix<Scalar, 7 + dof, 1> position(const FloatingConfiguration<Scalar, dof>& at) {
    Eigen::Matrix<Scalar, 7 + dof, 1> result;
    result << at.base.position, at.base.orientation.coeffs(), at.q;
    return result;
  }
  template <int dof, class Scalar>
  static FloatingConfiguration<Scalar, dof> configuration(const Eigen::Matrix<Scalar, 7 + dof, 1>& q) {
    return {{Quaternion<Scalar>(q[6], q[3], q[4], q[5]), q.template head<3>()}, q.template tail<dof>()};
  }
  // Velocities, accelerations and forces are those of this library.
};

struct MuJoCo : detail::LinearInWorld<false> {
  template <class Scalar, int dof>
  static Eigen::Matrix<Scalar, 7 + dof, 1> position(const FloatingConfiguration<Scalar, dof>& at) {
    const Quaternion<Scalar>& r = at.base.orientation;
    Eigen::Matrix<Scalar, 7 + dof, 1> result;
    result << at.base.position, r.w(), r.x(), r.y(), r.z(), at.q;
    return result;
  }
  template <int dof, class Scalar>
  static FloatingConfiguration<Scalar, dof> configuration(const Eigen::Matrix<Scalar, 7 + dof, 1>& q) {
    return {{Quaternion<Scalar>(q[3], q[4], q[5], q[6]), q.template head<3>()}, q.template tail<dof>()};
  }
  /// Back from MuJoCo's accelerations; `qd` as here.
  template <class Scalar, int dof>
  static Vector<Scalar, dof> acceleration_to_base(const FloatingConfiguration<Scalar, dof>& at,
                                                  const Vector<Scalar, dof>& qd,
                                                  const Vector<Scalar, dof>& acceleration) {
    return detail::without_turning<Scalar, 6 + dof>(qd, to_base(at, acceleration), Scalar(-1));
  }
};

struct Drake {
  template <class Scalar, int dof>
  using Vector = Eigen::Matrix<Scalar, 6 + dof, 1>;

  template <class Scalar, int dof>
  static Eigen::Matrix<Scalar, 7 + dof, 1> position(const FloatingConfiguration<Scalar, dof>& at) {
    const Quaternion<Scalar>& r = at.base.orientation;
    Eigen::Matrix<Scalar, 7 + dof, 1> result;
    result << r.w(), r.x(), r.y(), r.z(), at.base.position, at.q;
    return result;
  }
  template <int dof, class Scalar>
  static FloatingConfiguration<Scalar, dof> configuration(const Eigen::Matrix<Scalar, 7 + dof, 1>& q) {
    return {{Quaternion<Scalar>(q[0], q[1], q[2], q[3]), q.template segment<3>(4)}, q.template tail<dof>()};
  }
  template <class Scalar, int dof>
  static Vector<Scalar, dof> velocity(const FloatingConfiguration<Scalar, dof>& at,
                                      const Vector<Scalar, dof>& qd) {
    return detail::with_halves_exchanged<Scalar, 6 + dof>(InWorld::velocity(at, qd));
  }
  template <class Scalar, int dof>
  static Vector<Scalar, dof> acceleration(const FloatingConfiguration<Scalar, dof>& at,
                                          const Vector<Scalar, dof>& qd, const Vector<Scalar, dof>& qdd) {
    return detail::with_halves_exchanged<Scalar, 6 + dof>(InWorld::acceleration(at, qd, qdd));
  }
  template <class Scalar, int dof>
  static Vector<Scalar, dof> force(const FloatingConfiguration<Scalar, dof>& at,
                                   const Vector<Scalar, dof>& force) {
    return velocity(at, force);
  }
  /// Back from Drake's: velocities or forces.
  template <class Scalar, int dof>
  static Vector<Scalar, dof> to_base(const FloatingConfiguration<Scalar, dof>& at,
                                     const Vector<Scalar, dof>& values) {
    return InWorld::to_base(at, detail::with_halves_exchanged<Scalar, 6 + dof>(values));
  }
};

}  // namespace qvgen
