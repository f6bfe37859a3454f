// SPDX-License-Identifier: MIT
#include "newton_euler_values.h"

#include <vector>

#include <Eigen/Geometry>

namespace qvgen::test::sources {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// One link's motion and loads in the base frame.
struct Link {
  Matrix3d frame;  ///< from the link's frame
  Vector3d origin;
  Vector3d axis;
  Vector3d omega = Vector3d::Zero();
  Vector3d alpha = Vector3d::Zero();
  Vector3d acceleration = Vector3d::Zero();  ///< of the origin
  Vector3d centre = Vector3d::Zero();        ///< of mass, from the origin
  Vector3d centre_acceleration = Vector3d::Zero();
  Vector3d force = Vector3d::Zero();   ///< F
  Vector3d moment = Vector3d::Zero();  ///< N, about the centre of mass
  Vector3d joint_force = Vector3d::Zero();
  Vector3d joint_moment = Vector3d::Zero();  ///< about the origin
};

Vector3d carried(const Link& link, const Vector3d& point) {
  return link.acceleration + link.alpha.cross(point) + link.omega.cross(link.omega.cross(point));
}

std::vector<Link> places(const reference::Chain& chain, const VectorXd& q) {
  const std::vector<Eigen::Isometry3d> frames = reference::frames(chain, q);
  const std::vector<reference::JointPlace> joints = reference::joint_places(chain, q);
  std::vector<Link> links(chain.joints.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    links[i].frame = frames[i].linear();
    links[i].origin = frames[i].translation();
    links[i].axis = joints[i].axis;
  }
  return links;
}

void move(const reference::Joint& joint, const Link& before, double rate, double acceleration, Link& link) {
  link.omega = before.omega;
  link.alpha = before.alpha;
  if (joint.revolute) {
    link.omega += rate * link.axis;
    link.alpha += acceleration * link.axis + before.omega.cross(rate * link.axis);
  }
  // The links of these arms turn about their origins.
  link.acceleration = carried(before, link.origin - before.origin);
  if (!joint.revolute)
    link.acceleration += acceleration * link.axis + 2 * before.omega.cross(rate * link.axis);
  link.centre = link.frame * joint.centre_of_mass;
  link.centre_acceleration = carried(link, link.centre);
  const Matrix3d inertia = link.frame * joint.inertia * link.frame.transpose();
  link.force = joint.mass * link.centre_acceleration;
  link.moment = inertia * link.alpha + link.omega.cross(inertia * link.omega);
}

void load(const Link* after, Link& link) {
  link.joint_force = link.force;
  link.joint_moment = link.moment + link.centre.cross(link.force);
  if (after == nullptr) return;
  link.joint_force += after->joint_force;
  link.joint_moment += after->joint_moment + (after->origin - link.origin).cross(after->joint_force);
}

std::vector<Link> motion(const reference::Chain& chain, const VectorXd& q, const VectorXd& qd,
                         const VectorXd& qdd, double gravity) {
  std::vector<Link> links = places(chain, q);
  Link base{Matrix3d::Identity(), Vector3d::Zero(), Vector3d::UnitZ()};
  base.acceleration = gravity * Vector3d::UnitZ();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    move(chain.joints[i], i == 0 ? base : links[i - 1], qd[k], qdd[k], links[i]);
  }
  for (std::size_t i = links.size(); i > 0; --i) load(i < links.size() ? &links[i] : nullptr, links[i - 1]);
  return links;
}

void add_vector(const std::string& name, const Vector3d& value, const std::string& number, Known& known) {
  const std::size_t accent = name.find('\'');
  const std::string base = name.substr(0, accent);
  const std::string dots = accent == std::string::npos ? "" : name.substr(accent);
  known[base + number + dots] = value;
  for (int k = 0; k < 3; ++k) known[base + "xyz"[k] + number + dots] = value[k];
}

void add_axes(const std::string& number, Known& known) {
  known["X" + number] = Vector3d(Vector3d::UnitX());
  known["Y" + number] = Vector3d(Vector3d::UnitY());
  known["Z" + number] = Vector3d(Vector3d::UnitZ());
}

void add_link(const reference::Joint& joint, const Link& link, const std::string& number, Known& known) {
  const auto local = [&](const Vector3d& v) { return Vector3d(link.frame.transpose() * v); };
  add_vector("omega", local(link.omega), number, known);
  add_vector("omega'", local(link.alpha), number, known);
  add_vector("v'", local(link.acceleration), number, known);
  add_vector("vC'", local(link.centre_acceleration), number, known);
  add_vector("F", local(link.force), number, known);
  add_vector("N", local(link.moment), number, known);
  add_vector("f", local(link.joint_force), number, known);
  add_vector("n", local(link.joint_moment), number, known);
  known["PC" + number] = joint.centre_of_mass;
  known["R" + number] = local(link.axis);
  known["I" + number] = Eigen::MatrixXd(joint.inertia);
  known["tau" + number] = link.axis.dot(joint.revolute ? link.joint_moment : link.joint_force);
  add_axes(number, known);
}

/// The link's displacement from the one before.
void add_displacement(const Link* before, const Link& link, const std::string& number, Known& known) {
  const Matrix3d frame = before == nullptr ? Matrix3d(Matrix3d::Identity()) : before->frame;
  const Vector3d origin = before == nullptr ? Vector3d(Vector3d::Zero()) : before->origin;
  const Eigen::Quaterniond turn(Matrix3d(frame.transpose() * link.frame));
  const double sign = turn.w() < 0 ? -1 : 1;
  known["q" + number] = Quaternion{sign * turn.w(), sign * turn.vec()};
  known["P" + number] = Vector3d(frame.transpose() * (link.origin - origin));
}

/// The base at rest, and nothing behind the last link.
void add_ends(double gravity, std::size_t links, Known& known) {
  add_axes("0", known);
  known["omega0"] = known["omega0'"] = Vector3d(Vector3d::Zero());
  known["v0'"] = Vector3d(gravity * Vector3d::UnitZ());
  const std::string after = std::to_string(links + 1);
  known["f" + after] = known["n" + after] = known["P" + after] = Vector3d(Vector3d::Zero());
  known["q" + after] = Quaternion();
}

}  // namespace

Known newton_euler_values(const reference::Chain& chain, const reference::Values& constants,
                          const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) {
  Known known;
  for (const auto& [name, value] : constants) known[name] = value;
  const double gravity = constants.at("g");
  const std::vector<Link> links = motion(chain, q, qd, qdd, gravity);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const reference::Joint& joint = chain.joints[i];
    const auto k = static_cast<Eigen::Index>(i);
    known[joint.variable] = q[k];
    known[joint.variable + "'"] = qd[k];
    known[joint.variable + "''"] = qdd[k];
    add_link(joint, links[i], std::to_string(i + 1), known);
    add_displacement(i == 0 ? nullptr : &links[i - 1], links[i], std::to_string(i + 1), known);
    known["m" + std::to_string(i + 1)] = joint.mass;
  }
  add_ends(gravity, links.size(), known);
  return known;
}

}  // namespace qvgen::test::sources
