// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exact/point.h"
#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// The Newton-Euler recursion as it stands in the books (thesis 5.1-5.15, with the indices of 5.7-5.13 put
/// right), straight from the description: link frames as given, ten inertial parameters a link, nothing
/// simplified, no graph. In exact numbers, so that generated functions can be held against it with tolerance
/// zero.
class PlainRecursion {
 public:
  using Number = exact::Number;
  using Values = std::vector<Number>;

  PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point)
      : PlainRecursion(robot, point, robot.joints.size(), 0) {}
  /// The same with one joint moved: by that many times pi (revolute) or by that length (prismatic).
  PlainRecursion(const model::Robot& robot, const exact::ExactPoint& point, std::size_t moved,
                 const cln::cl_RA& by);

  /// All inertias from the standard parameters' values at the point, no drives.
  void take_standard_parameters();

  /// Generalised forces for joint rates and accelerations; `gravity` is the base acceleration along the
  /// world's +z. Drives (rotor inertia, friction of both kinds) are included.
  [[nodiscard]] Values inverse_dynamics(const Values& rates, const Values& accelerations,
                                        const Number& gravity) const;
  /// Row by row, both triangles: columns by unit accelerations at rest without gravity.
  [[nodiscard]] std::vector<Values> mass_matrix() const;
  /// Sum of m v^2/2 + w I w/2 over the links and of the rotors' energies.
  [[nodiscard]] Number kinetic_energy(const Values& rates) const;
  /// Sum of m g z over the links' centres of mass, z in the world.
  [[nodiscard]] Number potential_energy(const Number& gravity) const;

  /// Values of the joints' rates, accelerations and forces at the point.
  [[nodiscard]] Values rates() const;
  [[nodiscard]] Values accelerations() const;
  [[nodiscard]] Values forces() const;
  [[nodiscard]] std::size_t size() const { return links_.size(); }

 private:
  using Vector = std::array<Number, 3>;
  using Matrix = std::array<Vector, 3>;
  struct Frame {
    Matrix rotation;
    Vector position;
  };
  struct Link {
    bool revolute = true;
    std::string variable;
    Frame before, motion, after;
    Vector axis;
    Number mass, rotor, viscous, coulomb, direction;
    Vector centre;
    Matrix inertia;
  };

  [[nodiscard]] std::vector<Frame> link_frames() const;
  [[nodiscard]] Frame frame_of(const model::Displacement& displacement) const;
  [[nodiscard]] Vector vector_of(const model::Vector3& v) const;
  [[nodiscard]] Number number_of(const model::Expression& expression) const;
  [[nodiscard]] Matrix rotation(const Vector& axis, const exact::Angle& angle) const;

  const exact::ExactPoint& point_;
  Frame base_;
  std::vector<Link> links_;
};

}  // namespace qvgen::derive::dynamics
