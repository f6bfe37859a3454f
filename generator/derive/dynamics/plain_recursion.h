// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exact/point.h"
#include "model/followers.h"

namespace qvgen::derive::dynamics {

/// The Newton-Euler recursion as it stands in the books (thesis 5.1-5.15, with the indices of 5.7-5.13 put
/// right), straight from the description: link frames as given, ten inertial parameters a link, nothing
/// simplified, no graph. In exact numbers, so that generated functions can be held against it with tolerance
/// zero. Rates, accelerations and forces are by coordinates (model/coordinates.h). A floating base is at the
/// world's origin, turned as the world; the gravity that it sees is given.
class PlainRecursion {
 public:
  using Number = exact::Number;
  using Values = std::vector<Number>;

  PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point)
      : PlainRecursion(robot, point, {robot.joints.size(), {}, 0}) {}
  /// One joint of the chain further than at the point: by an angle (revolute) or by a length (prismatic).
  struct Move {
    std::size_t joint;
    exact::CosineSine turn;
    Number length;
  };
  PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point, const Move& move);

  /// All inertias from the standard parameters' values at the point, no drives.
  void take_standard_parameters();
  /// All drives from the drive parameters' values at the point, offsets included.
  void take_drive_parameters();
  void remove_friction();

  using Vector = std::array<Number, 3>;
  /// Load on the robot besides its drives, in the world.
  struct Load {
    Vector gravity;        ///< acceleration of free fall
    Vector force, moment;  ///< from outside on the tool, about the tool point
  };
  /// Gravity as the robot's functions are told of it: along -z, or in the frame of a base that floats.
  [[nodiscard]] Load usual_load() const;
  /// Gravity of that magnitude along -z and nothing else.
  static Load falling(const Number& gravity) { return {{0, 0, -gravity}, {}, {}}; }
  /// The values of the symbols at the point.
  [[nodiscard]] Load load(bool wrench) const;

  /// Generalised forces for joint rates and accelerations. Drives (rotor inertia, friction of both kinds) are
  /// included.
  [[nodiscard]] Values inverse_dynamics(const Values& rates, const Values& accelerations,
                                        const Load& load) const;
  [[nodiscard]] Values inverse_dynamics(const Values& rates, const Values& accelerations,
                                        const Number& gravity) const {
    return inverse_dynamics(rates, accelerations, falling(gravity));
  }
  /// Row by row, both triangles: columns by unit accelerations at rest without gravity.
  [[nodiscard]] std::vector<Values> mass_matrix() const;
  /// Sum of m v^2/2 + w I w/2 over the links and of the rotors' energies.
  [[nodiscard]] Number kinetic_energy(const Values& rates) const;
  /// Minus the sum of m gravity . r over the links' centres of mass r in the world.
  [[nodiscard]] Number potential_energy(const Vector& gravity) const;
  /// Likewise of a floating base, which is not at the origin: minus its mass times gravity . position is
  /// given.
  [[nodiscard]] Number potential_energy_of_floating_base() const;
  [[nodiscard]] bool floats() const { return base_motions_ > 0; }
  [[nodiscard]] Number total_mass() const;
  /// The sum of m r over the links' centres of mass r in the world, divided by the mass.
  [[nodiscard]] Vector centre_of_mass() const;

  /// Values of the joints' rates, accelerations and forces at the point.
  [[nodiscard]] Values rates() const;
  [[nodiscard]] Values accelerations() const;
  [[nodiscard]] Values forces() const;
  [[nodiscard]] std::size_t size() const { return driven_.size(); }

 private:
  using Matrix = std::array<Vector, 3>;
  struct Frame {
    Matrix rotation;
    Vector position;
  };
  struct Link {
    bool revolute = true;
    std::string variable;
    std::size_t parent;  ///< model::parent_of
    Frame before, motion, after;
    Vector axis;
    Number mass, rotor, viscous, coulomb, direction;
    Number offset = 0;  ///< a force of the drive at rest; no description gives one
    Vector centre;
    Matrix inertia;
  };

  /// Motion of a body in the world: angular velocity and its rate, velocity and acceleration of its origin.
  struct Moving {
    Vector w, dw, v, a, origin;
    Matrix rotation;

    /// Takes the acceleration to another point of the body, which becomes its origin.
    void go_to(const Vector& point);
  };
  /// A link in the world: axis and origin of its joint, centre of mass, the force that moves it, and the
  /// moment about that centre.
  struct Body {
    Vector axis, origin, centre, force, moment;
  };
  /// Forces of all joints, behind force and moment that a floating base takes.
  struct Forces {
    Vector force, moment;
    Values joints;
  };

  void take_standard_parameters_of(std::size_t body, Number& mass, Vector& centre, Matrix& inertia) const;
  [[nodiscard]] Values of_chain(const Values& coordinates) const;
  static Vector go_over_joint(const Link& link, const Number& rate, const Number& acceleration, Moving& here);
  [[nodiscard]] std::vector<Body> bodies_of(const Moving& base, const Values& rates,
                                            const Values& accelerations) const;
  [[nodiscard]] Number carried_by(std::size_t joint, const std::vector<Body>& bodies, const Vector& tool,
                                  const Load& load) const;
  [[nodiscard]] Forces forces_of_chain(const Moving& base, const Values& rates, const Values& accelerations,
                                       const Load& load) const;
  /// Returns the base's motion under gravity, at rest if it does not float.
  [[nodiscard]] Moving base_motion(const Values& rates, const Values& accelerations, const Load& load) const;
  [[nodiscard]] std::vector<Frame> link_frames() const;
  /// True if link i carries link k, or is it.
  [[nodiscard]] bool carries(std::size_t i, std::size_t k) const;
  [[nodiscard]] Frame frame_of(const model::Displacement& displacement) const;
  [[nodiscard]] Vector vector_of(const model::Vector3& v) const;
  [[nodiscard]] Matrix tensor_of(const model::Inertia& inertia) const;
  [[nodiscard]] Number number_of(const model::Expression& expression) const;
  [[nodiscard]] exact::CosineSine turn(const exact::Angle& angle) const;

  const exact::ExactPoint& point_;
  Frame base_;
  Vector tool_;  ///< in the last link's frame
  std::vector<Link> links_;
  /// Drive of a motor: inertia, friction of both kinds, offset, and the sign of its rate.
  struct Drive {
    std::optional<std::size_t> motor = {};  ///< index among the robot's motors
    Number rotor, viscous, coulomb, offset, direction;
  };
  /// Nothing for a joint: its link has the drive.
  [[nodiscard]] Drive drive_of(const model::Robot& robot, const model::Joint& driven) const;

  std::vector<std::vector<model::Share>> shares_;  ///< of the chain's joints
  std::vector<std::string> driven_;  ///< coordinates: those of the base, variables of the motors
  std::vector<Drive> drives_;        ///< by motor
  std::size_t base_motions_ = 0;
  Number base_mass_;  ///< of a floating base
  Vector base_centre_{};
  Matrix base_inertia_{};
};

}  // namespace qvgen::derive::dynamics
