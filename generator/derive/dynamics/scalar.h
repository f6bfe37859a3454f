// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "dag/graph.h"

namespace qvgen::derive::dynamics {

/// A value of a graph under construction, so that recursions read as in the books. A default one is zero.
///
/// Zeros and ones vanish as they come, which is how the structure of a robot (right angles, absent inertias)
/// reaches the graph. The graph must outlive its scalars.
class Scalar {
 public:
  Scalar() = default;
  Scalar(dag::Graph& graph, dag::Edge edge) : graph_(graph.is_zero(edge) ? nullptr : &graph), edge_(edge) {}

  [[nodiscard]] bool is_zero() const { return graph_ == nullptr; }
  [[nodiscard]] bool is_one() const { return graph_ != nullptr && graph_->is_one(edge_); }
  /// The edge in that graph (a zero belongs to none).
  [[nodiscard]] dag::Edge in(dag::Graph& graph) const { return is_zero() ? graph.constant(0) : edge_; }

  Scalar operator-() const { return is_zero() ? Scalar() : Scalar(*graph_, -edge_); }
  friend Scalar operator+(const Scalar& a, const Scalar& b) {
    if (a.is_zero()) return b;
    return b.is_zero() ? a : Scalar(*a.graph_, a.graph_->sum({a.edge_, b.edge_}));
  }
  friend Scalar operator-(const Scalar& a, const Scalar& b) { return a + -b; }
  friend Scalar operator*(const Scalar& a, const Scalar& b) {
    if (a.is_zero() || b.is_zero()) return {};
    return Scalar(*a.graph_, a.graph_->product({a.edge_, b.edge_}));
  }
  friend Scalar operator/(const Scalar& a, const Scalar& b) {
    return a.is_zero() ? a : Scalar(*b.graph_, b.graph_->quotient(a.edge_, b.edge_));
  }

 private:
  dag::Graph* graph_ = nullptr;
  dag::Edge edge_;
};

using Vector3 = std::array<Scalar, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< rows

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector3 operator-(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return a + -b; }
inline Vector3 operator*(const Scalar& s, const Vector3& v) { return {s * v[0], s * v[1], s * v[2]}; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector3 column(const Matrix3& m, std::size_t k) { return {m[0][k], m[1][k], m[2][k]}; }

/// Cosine and sine of one angle.
struct Circle {
  Scalar cosine, sine;
};

/// Rotation about axis k (0, 1, 2) by the angle; `unrotate` is its inverse.
inline Vector3 rotate(std::size_t k, const Circle& by, const Vector3& v) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  Vector3 result;
  result[i] = by.cosine * v[i] - by.sine * v[j];
  result[j] = by.sine * v[i] + by.cosine * v[j];
  result[k] = v[k];
  return result;
}
inline Vector3 unrotate(std::size_t k, const Circle& by, const Vector3& v) {
  return rotate(k, {by.cosine, -by.sine}, v);
}

}  // namespace qvgen::derive::dynamics
