// SPDX-License-Identifier: MIT
#include "reference/dynamics.h"

#include "reference/linear_algebra.h"

namespace reference {
namespace {

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Motion of a link and what must act on it, all in the world frame.
struct Link {
  Vector3d angular_velocity = Vector3d::Zero();
  Vector3d angular_acceleration = Vector3d::Zero();
  Vector3d centre = Vector3d::Zero();  ///< of mass
  Vector3d centre_velocity = Vector3d::Zero();
  Vector3d force = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();  ///< about the centre of mass
};

/// Velocity and acceleration of the point `to` of a rigid body of which those of the point `from` are known.
struct PointMotion {
  Vector3d velocity;
  Vector3d acceleration;
};
PointMotion carry(const PointMotion& motion, const Link& body, const Vector3d& from, const Vector3d& to) {
  const Vector3d r = to - from;
  const Vector3d& w = body.angular_velocity;
  return {motion.velocity + w.cross(r),
          motion.acceleration + body.angular_acceleration.cross(r) + w.cross(w.cross(r))};
}

/// Rates and accelerations of the joints with values of their own.
std::vector<Link> moving_links(const Chain& chain, const VectorXd& values, const VectorXd& rates,
                               const VectorXd& accelerations, const Vector3d& base_acceleration) {
  const MatrixXd coupling = chain.coupling();
  const VectorXd q = coupling * values, qd = coupling * rates, qdd = coupling * accelerations;
  const std::vector<Isometry3d> frame = frames(chain, values);
  const std::vector<JointPlace> places = joint_places(chain, values);
  std::vector<Link> links;
  std::vector<PointMotion> at_origins;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Eigen::Index carrier = chain.parent_of(i);
    const auto parent = static_cast<std::size_t>(carrier);
    const bool on_base = carrier < 0;  // which does not turn
    const Link previous = on_base ? Link() : links[parent];
    const Vector3d origin =
        on_base ? Vector3d(chain.base.translation()) : Vector3d(frame[parent].translation());
    const PointMotion at_origin =
        on_base ? PointMotion{Vector3d::Zero(), base_acceleration} : at_origins[parent];
    const auto n = static_cast<Eigen::Index>(i);
    const Joint& joint = chain.joints[i];
    const Vector3d& axis = places[i].axis;
    const Vector3d& w = previous.angular_velocity;
    Link link = previous;
    Vector3d point = places[i].point;
    PointMotion motion;
    if (joint.revolute) {
      motion = carry(at_origin, previous, origin, point);
      link.angular_velocity = w + axis * qd[n];
      link.angular_acceleration = previous.angular_acceleration + axis * qdd[n] + w.cross(axis) * qd[n];
    } else {
      point += axis * q[n];
      motion = carry(at_origin, previous, origin, point);
      motion.velocity += axis * qd[n];
      motion.acceleration += axis * qdd[n] + 2 * w.cross(axis) * qd[n];  // Coriolis
    }
    link.centre = frame[i] * joint.centre_of_mass;
    const PointMotion centre = carry(motion, link, point, link.centre);
    const Matrix3d inertia = frame[i].linear() * joint.inertia * frame[i].linear().transpose();
    link.centre_velocity = centre.velocity;
    link.force = joint.mass * centre.acceleration;
    link.moment =
        inertia * link.angular_acceleration + link.angular_velocity.cross(inertia * link.angular_velocity);
    at_origins.push_back(carry(motion, link, point, frame[i].translation()));
    links.push_back(link);
  }
  return links;
}

/// Forces of the drives of motors that are no joints.
VectorXd drives_of_motors(const Chain& chain, const VectorXd& rates, const VectorXd& accelerations) {
  const std::vector<std::string> names = chain.driven();
  VectorXd tau = VectorXd::Zero(chain.size());
  for (const Motor& motor : chain.motors)
    for (Eigen::Index k = 0; k < tau.size(); ++k)
      if (names[static_cast<std::size_t>(k)] == motor.variable)
        tau[k] = motor.rotor_inertia * accelerations[k] + motor.viscous_friction * rates[k] +
                 motor.coulomb_friction * sign(rates[k]);
  return tau;
}

}  // namespace

VectorXd inverse_dynamics(const Chain& chain, const VectorXd& q, const VectorXd& rates,
                          const VectorXd& accelerations, const Vector3d& base_acceleration) {
  const std::vector<Link> links = moving_links(chain, q, rates, accelerations, base_acceleration);
  const MatrixXd coupling = chain.coupling();
  const VectorXd qd = coupling * rates, qdd = coupling * accelerations;
  const std::vector<JointPlace> places = joint_places(chain, q);
  VectorXd tau(coupling.rows());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Joint& joint = chain.joints[i];
    Vector3d force = Vector3d::Zero();
    Vector3d moment =
        Vector3d::Zero();  // about the joint's point; for a prismatic joint only the force counts
    for (std::size_t j = i; j < links.size(); ++j) {
      if (!chain.moves(i, j)) continue;
      force += links[j].force;
      moment += links[j].moment + (links[j].centre - places[i].point).cross(links[j].force);
    }
    const auto n = static_cast<Eigen::Index>(i);
    tau[n] = places[i].axis.dot(joint.revolute ? moment : force) + joint.rotor_inertia * qdd[n] +
             joint.viscous_friction * qd[n] + joint.coulomb_friction * sign(qd[n]);
  }
  return coupling.transpose() * tau + drives_of_motors(chain, rates, accelerations);  // virtual work
}

MatrixXd mass_matrix(const Chain& chain, const VectorXd& q) {
  const Eigen::Index n = chain.size();
  MatrixXd result(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    result.col(j) = inverse_dynamics(chain, q, VectorXd::Zero(n), VectorXd::Unit(n, j), Vector3d::Zero());
  }
  return result;
}

VectorXd forward_dynamics(const Chain& chain, const VectorXd& q, const VectorXd& qd, const VectorXd& tau,
                          const Vector3d& base_acceleration) {
  const VectorXd bias = inverse_dynamics(chain, q, qd, VectorXd::Zero(chain.size()), base_acceleration);
  return solve_symmetric(mass_matrix(chain, q), tau - bias);
}

double kinetic_energy(const Chain& chain, const VectorXd& q, const VectorXd& rates) {
  const VectorXd qd = chain.coupling() * rates;
  const std::vector<Isometry3d> frame = frames(chain, q);
  const auto links = moving_links(chain, q, rates, VectorXd::Zero(chain.size()), Vector3d::Zero());
  double energy = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Joint& joint = chain.joints[i];
    const Vector3d w = frame[i].linear().transpose() * links[i].angular_velocity;
    energy += joint.mass * links[i].centre_velocity.squaredNorm() / 2 + w.dot(joint.inertia * w) / 2 +
              joint.rotor_inertia * qd[static_cast<Eigen::Index>(i)] * qd[static_cast<Eigen::Index>(i)] / 2;
  }
  const std::vector<std::string> names = chain.driven();
  for (const Motor& motor : chain.motors)
    for (Eigen::Index k = 0; k < rates.size(); ++k)
      if (names[static_cast<std::size_t>(k)] == motor.variable)
        energy += motor.rotor_inertia * rates[k] * rates[k] / 2;
  return energy;
}

double potential_energy(const Chain& chain, const VectorXd& q, const Vector3d& base_acceleration) {
  const std::vector<Isometry3d> frame = frames(chain, q);
  double energy = 0;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    energy += chain.joints[i].mass * base_acceleration.dot(frame[i] * chain.joints[i].centre_of_mass);
  }
  return energy;
}

double total_mass(const Chain& chain) {
  double sum = 0;
  for (const Joint& joint : chain.joints) sum += joint.mass;
  return sum;
}

Vector3d centre_of_mass(const Chain& chain, const VectorXd& q) {
  const std::vector<Isometry3d> links = frames(chain, q);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    sum += chain.joints[i].mass * (links[i] * chain.joints[i].centre_of_mass);
  return sum / total_mass(chain);
}

MatrixXd centre_of_mass_jacobian(const Chain& chain, const VectorXd& q) {
  MatrixXd sum = MatrixXd::Zero(3, chain.size());
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Isometry3d at_centre(Eigen::Translation3d(chain.joints[i].centre_of_mass));
    sum += chain.joints[i].mass * jacobian_of(chain, {"", i, at_centre}, q).topRows(3);
  }
  return sum / total_mass(chain);
}

}  // namespace reference
