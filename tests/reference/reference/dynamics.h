// SPDX-License-Identifier: MIT
#pragma once

#include "reference/chain.h"

namespace reference {

/// Gravity of 9.81 m/s² along -z, as the acceleration that the base would need in free space: +9.81 along z.
inline const Vector3d standing{0, 0, 9.81};

/// Joint torques (N m) and forces (N) for q, qd, qdd: Newton and Euler for every link in the world frame,
/// then for each joint the sum over all links behind it. Friction and rotor inertia included.
/// base_acceleration: of the base in the world frame; minus the gravitational acceleration for an arm at
/// rest.
VectorXd inverse_dynamics(const Chain& chain, const VectorXd& q, const VectorXd& qd, const VectorXd& qdd,
                          const Vector3d& base_acceleration = standing);

/// n x n, kg m² (kg, kg m): column j is the torque of unit acceleration of joint j.
MatrixXd mass_matrix(const Chain& chain, const VectorXd& q);

/// Accelerations that the torques tau cause.
VectorXd forward_dynamics(const Chain& chain, const VectorXd& q, const VectorXd& qd, const VectorXd& tau,
                          const Vector3d& base_acceleration = standing);

/// J, of links and rotors.
double kinetic_energy(const Chain& chain, const VectorXd& q, const VectorXd& qd);
/// J, zero with all masses at the world's origin.
double potential_energy(const Chain& chain, const VectorXd& q, const Vector3d& base_acceleration = standing);

/// kg, of all links.
double total_mass(const Chain& chain);
/// m, in the world frame.
Vector3d centre_of_mass(const Chain& chain, const VectorXd& q);
/// 3 x n: its derivatives by the joints, the mean by mass of those of the links' own centres.
MatrixXd centre_of_mass_jacobian(const Chain& chain, const VectorXd& q);

}  // namespace reference
