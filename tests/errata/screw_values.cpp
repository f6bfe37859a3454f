// SPDX-License-Identifier: MIT
#include "screw_values.h"

#include <array>

#include <Eigen/Geometry>

namespace qvgen::test::sources {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Translation3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

MatrixXd column(const Vector3d& point) {
  MatrixXd result(4, 1);
  result << point, 1;
  return result;
}

/// A point as a vector, as a column of four, by its components.
void add_point(const std::string& name, const Vector3d& point, Known& known) {
  known[name] = point;
  known["h" + name] = column(point);
  for (int i = 0; i < 3; ++i) known[name + "xyz"[i]] = point[i];
}

/// Returns the component of a vector across an axis.
Vector3d across(const Vector3d& axis, const Vector3d& v) { return v - axis.dot(v) * axis; }

struct Arm {
  std::array<Vector3d, 6> axes;
  std::array<Vector3d, 6> points;  ///< on them
  std::array<Isometry3d, 6> turns;

  /// e_first ... e_last, numbered from 1.
  [[nodiscard]] Isometry3d product(std::size_t first, std::size_t last) const {
    Isometry3d result = Isometry3d::Identity();
    for (std::size_t i = first; i <= last; ++i) result = result * turns[i - 1];
    return result;
  }
};

/// With the points of all axes but the first moved.
Arm arm_of(const reference::Chain& chain, const VectorXd& q, const Vector3d& shift) {
  const auto places = reference::joint_places(chain, VectorXd::Zero(q.size()));
  Arm arm;
  for (std::size_t i = 0; i < 6; ++i) {
    arm.axes[i] = places[i].axis;
    arm.points[i] = i == 0 ? places[i].point : Vector3d(places[i].point + shift);
    arm.turns[i] = Translation3d(arm.points[i]) * AngleAxisd(q[static_cast<Eigen::Index>(i)], arm.axes[i]) *
                   Translation3d(-arm.points[i]);
  }
  return arm;
}

void add_matrix(const std::string& name, const Eigen::Matrix3d& matrix, Known& known) {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) known[name + std::to_string(10 * (i + 1) + k + 1)] = matrix(i, k);
}

void add_turns(const Arm& arm, Known& known) {
  for (std::size_t i = 0; i < 6; ++i) {
    known["e" + std::to_string(i + 1)] = MatrixXd(arm.turns[i].matrix());
    known["omega" + std::to_string(i + 1)] = arm.axes[i];
  }
  for (std::size_t i = 1; i <= 4; ++i)
    known["T" + std::to_string(i)] = MatrixXd(arm.product(i == 4 ? 6 : i == 3 ? 4 : i, 6).matrix());
}

/// u, v and what is of them across the axis, for a turn of `from` into `to` about an axis through `origin`.
void add_subproblem(const std::string& number, const Vector3d& axis, const Vector3d& origin,
                    const Vector3d& from, const Vector3d& to, Known& known) {
  known["u" + number] = Vector3d(from - origin);
  known["v" + number] = Vector3d(to - origin);
  known["u" + number + "*"] = across(axis, from - origin);
  known["v" + number + "*"] = across(axis, to - origin);
}

/// alpha, beta, gamma of a vector between two turns.
void add_coefficients(const Vector3d& z, const Vector3d& first, const Vector3d& second, Known& known) {
  const Vector3d normal = first.cross(second);
  const double c = first.dot(second), square = normal.squaredNorm();
  known["z"] = z;
  known["alpha"] = (z.dot(first) - c * z.dot(second)) / square;
  known["beta"] = (z.dot(second) - c * z.dot(first)) / square;
  known["gamma"] = z.dot(normal) / square;
}

void add_shifted_points(const Arm& arm, const reference::Values& lengths, Known& known) {
  const double a1 = lengths.at("a1"), a2 = lengths.at("a2"), a3 = lengths.at("a3");
  const Vector3d wrist = arm.points[3];
  add_point("q7", arm.turns[2] * wrist, known);
  add_point("p2", arm.product(1, 3) * wrist, known);
  add_point("p3", arm.product(2, 3) * wrist, known);
  const Vector3d elbow = arm.points[1];
  known["delta"] = (arm.turns[2] * wrist - elbow).norm();
  known["delta*"] = across(arm.axes[2], arm.turns[2] * wrist - elbow).norm();
  add_subproblem("3", arm.axes[2], arm.points[2], wrist, elbow, known);
  add_subproblem("2", arm.axes[1], arm.points[1], arm.turns[2] * wrist, arm.product(2, 3) * wrist, known);
  const Vector3d beside(0, 0, a1 + a2 + a3);
  add_point("q6**", beside, known);
  add_point("p4", arm.product(4, 5) * beside, known);
  known["hc"] = column(arm.turns[4] * beside);
  known["u4"] = Vector3d(beside - wrist);
  known["v4"] = Vector3d(arm.product(4, 5) * beside - wrist);
  add_coefficients(arm.turns[4] * beside - wrist, arm.axes[3], arm.axes[4], known);
  const Vector3d last(0, 0, a1 + a2);
  add_point("q8", last, known);
  add_point("p5", arm.turns[5] * last, known);
  add_subproblem("6", arm.axes[5], beside, last, arm.turns[5] * last, known);
}

void add_pose(const Isometry3d& pose, const Arm& arm, Known& known) {
  known["T"] = MatrixXd(pose.matrix());
  const char* const names[] = {"px", "py", "pz"};
  for (int i = 0; i < 3; ++i) known[names[i]] = pose.translation()[i];
  add_matrix("r", pose.linear(), known);
  add_matrix("w", arm.product(1, 3).linear().transpose() * pose.linear(), known);
}

}  // namespace

Known screw_values(const std::string& of, const reference::Chain& chain, const reference::Values& lengths,
                   const VectorXd& q) {
  Known known;
  for (const auto& [name, value] : lengths) known[name] = value;
  for (std::size_t i = 0; i < 6; ++i) known[chain.joints[i].variable] = q[static_cast<Eigen::Index>(i)];
  const double d1 = lengths.at("d1");
  const Arm arm = arm_of(chain, q, Vector3d::Zero());
  const Arm shifted = arm_of(chain, q, {-d1, 0, 0});
  add_pose(reference::forward_kinematics(chain, q), arm, known);
  const Isometry3d zero = reference::forward_kinematics(chain, VectorXd::Zero(6));
  known["M"] = MatrixXd(zero.matrix());
  known["M*"] = MatrixXd((Translation3d(-d1, 0, 0) * zero).matrix());
  known["Tt"] = MatrixXd(Isometry3d(Translation3d(-d1 * std::cos(q[0]), -d1 * std::sin(q[0]), 0)).matrix());
  for (std::size_t i = 0; i < 6; ++i) {
    add_point("q" + std::to_string(i + 1), arm.points[i], known);
    add_point("q" + std::to_string(i + 1) + "*", shifted.points[i], known);
  }
  add_point("q456", arm.points[3], known);
  add_point("p1", arm.product(1, 3) * arm.points[3], known);
  add_turns(of == "shifted" ? shifted : arm, known);
  add_shifted_points(shifted, lengths, known);
  return known;
}

Known turned_twice(std::mt19937& engine) {
  std::uniform_real_distribution<double> number(-3, 3);
  const auto vector = [&] { return Vector3d(number(engine), number(engine), number(engine)); };
  const Vector3d first = vector().normalized(), second = vector().normalized(), u = vector();
  const Vector3d z = AngleAxisd(number(engine), second) * u;
  Known known{{"omega4", first}, {"omega5", second}, {"u4", u}};
  known["v4"] = Vector3d(AngleAxisd(number(engine), first) * z);
  add_coefficients(z, first, second, known);
  return known;
}

}  // namespace qvgen::test::sources
