// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "derive/dynamics/parametrisation.h"
#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// A joint with its links has no inertia at all: forward dynamics would divide by zero.
class MasslessLink : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// Symbols of a joint's rate, acceleration and generalised force: theta1', theta1'', theta1!.
std::string velocity_of(const std::string& variable);
std::string acceleration_of(const std::string& variable);
std::string force_of(const std::string& variable);
/// Symbol of the sign of a joint's rate, which Coulomb friction depends on: theta1~.
std::string direction_of(const std::string& variable);

/// Symbols of the wrench that acts on the tool from outside: force, then moment about the tool point, in the
/// world frame.
std::string wrench_component(std::size_t index);

/// Choices that a formulation leaves before the search, and loads on the robot.
struct FormulationOptions {
  FrameConvention convention;
  bool wrench = false;              ///< on the tool, from outside
  bool last_link_unrotated = true;  ///< the last link's frame does not turn: its parameters do
  /// Links whose wrench is offered in the frame before their joint's rotation as well.
  std::set<std::size_t> unrotated = {1};
};

/// A quantity in terms of joint variables and constants, with suggestions for the search among its outputs.
struct Formulation {
  dag::Function function;   ///< in joint variables, their derivatives and constants "$0", ...
  dag::Function constants;  ///< the constants in the description's symbols
};

/// Which generalised forces: of the whole motion, of gravity alone (at rest), of velocities alone (without
/// friction: C q'), or all that does not depend on the accelerations.
enum class Effects { all, gravity, velocity, bias };

/// Outputs tau1 ... taun: the Newton-Euler recursion in pseudo-inertia base parameters.
///
/// Formulates the inverse dynamics by U = [w'] + [w][w] of each body, where v' of a point r is U r
/// (Newton-Euler). It propagates mainly the column U z, which neighbouring links share (inverse of thesis
/// 5.2-5.4); with it
///   force   f = U h + m v',
///   moment  n = (U Sigma's antisymmetric part) + h x v'
/// replace thesis 5.6-5.13.
Formulation inverse_dynamics(const model::Robot& robot, const FormulationOptions& choices,
                             Effects effects = Effects::all);

/// Outputs m11, m12, ... (upper triangle, row by row): composite bodies (Walker and Orin 1982, Featherstone
/// 1987) in pseudo-inertia form.
Formulation mass_matrix(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs h11, h12, ... (row by row): the six rows of a floating base in the mass matrix, whose product with
/// the velocities is the momentum of all links, linear and about the base's origin, in the base's frame.
Formulation momentum_matrix(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs c11, c12, ... (row by row): the matrix of Christoffel's symbols, for which C q' are the forces of
/// Effects::velocity and M' - 2 C is skew-symmetric.
Formulation coriolis_matrix(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs tau1 ..., then for each coordinate k the derivatives q1_k, q2_k, ... of all forces by its position
/// and v1_k, v2_k, ... by its velocity, by composite bodies.
Formulation inverse_dynamics_derivatives(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs qdd1 ...: M^-1 (force - bias), by M = U D U^T from the last joint inward, without a square root.
Formulation forward_dynamics(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs qdd1 ..., without a mass matrix; nothing for joints that follow others, a wrench on the tool or a
/// unit of length.
std::optional<Formulation> forward_dynamics_by_articulated_bodies(const model::Robot& robot,
                                                                  const FormulationOptions& choices);

/// Output "energy": q' M q' / 2.
Formulation kinetic_energy(const model::Robot& robot, const FormulationOptions& choices);

/// Output "energy": gravity times the first moment of all links along the world's z.
Formulation potential_energy(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs cx, cy, cz: the centre of mass of all links in the world. It is the tip of an arm with the same
/// rotations whose lengths are averages by mass of the described ones, one length across each axis.
Formulation centre_of_mass(const model::Robot& robot, const FormulationOptions& choices);

/// Outputs jx1, jy1, jz1, jx2, ... (column by column): its derivatives by the joints, the Jacobian of that
/// tip.
Formulation centre_of_mass_jacobian(const model::Robot& robot, const FormulationOptions& choices);

}  // namespace qvgen::derive::dynamics
