// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "tree.h"

namespace qvgen::test::sources {

/// Quaternion of any length, as printed formulas have them; [s, v] in print.
struct Quaternion {
  double s = 1;
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
};
Quaternion operator*(const Quaternion& a, const Quaternion& b);
Quaternion inverse(const Quaternion& q);
/// q v q^-1.
Eigen::Vector3d rotated(const Quaternion& q, const Eigen::Vector3d& v);

/// A displacement: (q, p) moves a point x to q x q^-1 + p.
struct Pair {
  Quaternion q;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};
Pair operator*(const Pair& a, const Pair& b);
Pair inverse(const Pair& pair);

using Value = std::variant<double, Eigen::Vector3d, Quaternion, Pair, Eigen::MatrixXd>;
using Known = std::map<std::string, Value>;

/// `sign` is that of all ±. An angle theta3 is the known name "theta3"; s3, c3, hs3, hc3 need not be known.
/// Throws std::domain_error for what has no meaning, such as the sum of a number and a vector, and for names
/// that are not known.
Value value_of(const Tree& tree, const Known& known, double sign = 1);

/// Within 1e-9; a quaternion and its opposite are one rotation.
bool same(const Value& a, const Value& b);
/// The largest difference of an entry; infinity where one is a vector and the other a number, or one is NaN.
double distance(const Value& a, const Value& b);

}  // namespace qvgen::test::sources
