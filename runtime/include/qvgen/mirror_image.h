// SPDX-License-Identifier: MIT
// Limbs that are another limb seen in a mirror: what is computed for one holds for the other by changes of
// signs alone, to the last bit. With M = diag(x, y, z) of signs, positions and velocities are seen as M v,
// turns and angular velocities as det(M) M w; joint i of the image stands for signs[i] times its value in the
// other limb. In the frame of the tool the signs are T = diag(tx, ty, tz): its orientation is seen as M R T.
#pragma once

#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <qvgen/pose.h>

namespace qvgen {

/// Leads from an image to the limb that it is of, and back: each of these functions is its own inverse.
template <int x, int y, int z, int tx, int ty, int tz, int... signs>
struct MirrorImage {
  static constexpr int dof = sizeof...(signs);
  template <class Scalar>
  using Joints = Eigen::Matrix<Scalar, dof, 1>;
  template <class Scalar>
  using Columns = Eigen::Matrix<Scalar, 6, dof>;

  /// Returns a position, velocity, direction or force as it is seen.
  template <class Scalar>
  static Vector3<Scalar> vector(const Vector3<Scalar>& v) {
    return {seen<x>(v.x()), seen<y>(v.y()), seen<z>(v.z())};
  }

  /// Returns a position in the frame of the tool.
  template <class Scalar>
  static Vector3<Scalar> tool_vector(const Vector3<Scalar>& v) {
    return {seen<tx>(v.x()), seen<ty>(v.y()), seen<tz>(v.z())};
  }

  template <class Scalar>
  static Joints<Scalar> joints(const Joints<Scalar>& q) {
    return joints(q, std::make_integer_sequence<int, dof>());
  }

  /// Returns an orientation of the tool: M q M, and half a turn if axes of the tool are turned over besides.
  template <class Scalar>
  static Eigen::Quaternion<Scalar> rotation(const Eigen::Quaternion<Scalar>& q) {
    const Scalar w = q.w(), i = seen<y * z>(q.x()), j = seen<x * z>(q.y()), k = seen<x * y>(q.z());
    if constexpr (x * tx < 0 && y * ty < 0) return {-k, j, -i, w};
    if constexpr (x * tx < 0 && z * tz < 0) return {-j, -k, w, i};
    if constexpr (y * ty < 0 && z * tz < 0) return {-i, w, k, -j};
    return {w, i, j, k};
  }

  template <class Scalar>
  static Pose<Scalar> pose(const Pose<Scalar>& at) {
    return {rotation<Scalar>(at.orientation), vector<Scalar>(at.position)};
  }

  template <class Scalar>
  static Matrix3<Scalar> matrix(const Matrix3<Scalar>& r) {
    Matrix3<Scalar> result;
    result << seen<x * tx>(r(0, 0)), seen<x * ty>(r(0, 1)), seen<x * tz>(r(0, 2)),  //
        seen<y * tx>(r(1, 0)), seen<y * ty>(r(1, 1)), seen<y * tz>(r(1, 2)),        //
        seen<z * tx>(r(2, 0)), seen<z * ty>(r(2, 1)), seen<z * tz>(r(2, 2));
    return result;
  }

  template <class Scalar>
  static Eigen::Transform<Scalar, 3, Eigen::Isometry> transform(
      const Eigen::Transform<Scalar, 3, Eigen::Isometry>& at) {
    Eigen::Transform<Scalar, 3, Eigen::Isometry> result;
    result.linear() = matrix<Scalar>(at.linear());
    result.translation() = vector<Scalar>(at.translation());
    result.makeAffine();
    return result;
  }

  /// Returns a twist or an acceleration, linear part first.
  template <class Scalar>
  static Eigen::Matrix<Scalar, 6, 1> twist(const Eigen::Matrix<Scalar, 6, 1>& v) {
    Eigen::Matrix<Scalar, 6, 1> result;
    result << seen<x>(v[0]), seen<y>(v[1]), seen<z>(v[2]), seen<y * z>(v[3]), seen<x * z>(v[4]),
        seen<x * y>(v[5]);
    return result;
  }

  /// Returns a Jacobian: a twist for each joint.
  template <class Scalar>
  static Columns<Scalar> columns(const Columns<Scalar>& jacobian) {
    return columns<x, y, z>(jacobian, std::make_integer_sequence<int, dof>());
  }
  /// Returns a Jacobian in the frame of the tool.
  template <class Scalar>
  static Columns<Scalar> tool_columns(const Columns<Scalar>& jacobian) {
    return columns<tx, ty, tz>(jacobian, std::make_integer_sequence<int, dof>());
  }

 private:
  template <int sign, class Scalar>
  static Scalar seen(const Scalar& value) {
    if constexpr (sign < 0)
      return -value;
    else
      return value;
  }

  template <class Scalar, int... joint>
  static Joints<Scalar> joints(const Joints<Scalar>& q, std::integer_sequence<int, joint...>) {
    Joints<Scalar> result;
    ((result[joint] = seen<signs>(q[joint])), ...);
    return result;
  }

  /// Stores column j for a joint of that sign, seen in the mirror diag(a, b, c).
  template <int sign, int a, int b, int c, class Scalar>
  static void store(const Columns<Scalar>& jacobian, int j, Columns<Scalar>& to) {
    to(0, j) = seen<sign * a>(jacobian(0, j));
    to(1, j) = seen<sign * b>(jacobian(1, j));
    to(2, j) = seen<sign * c>(jacobian(2, j));
    to(3, j) = seen<sign * b * c>(jacobian(3, j));
    to(4, j) = seen<sign * a * c>(jacobian(4, j));
    to(5, j) = seen<sign * a * b>(jacobian(5, j));
  }
  template <int a, int b, int c, class Scalar, int... joint>
  static Columns<Scalar> columns(const Columns<Scalar>& jacobian, std::integer_sequence<int, joint...>) {
    Columns<Scalar> result;
    (store<signs, a, b, c>(jacobian, joint, result), ...);
    return result;
  }
};

}  // namespace qvgen
