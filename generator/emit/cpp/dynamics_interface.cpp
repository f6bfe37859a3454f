// SPDX-License-Identifier: MIT
#include <map>

#include "emit/cpp/dynamics_code.h"

namespace qvgen::emit {

namespace {

const std::map<std::string, DynamicsInterface>& known_interfaces() {
  static const std::map<std::string, DynamicsInterface> known = {
      {"inverse_dynamics",
       {{"q", "qd", "qdd"},
        Result::vector,
        Gravity::magnitude,
        "Joint forces for a motion: Newton-Euler recursion in base parameters (thesis 5.1-5.15)."}},
      {"gravity_torque",
       {{"q"},
        Result::vector,
        Gravity::magnitude,
        "Joint forces that hold the robot against gravity at rest."}},
      {"coriolis_torque",
       {{"q", "qd"},
        Result::vector,
        Gravity::none,
        "Joint forces that come from the joint rates alone, C(q, qd) qd, without friction."}},
      {"mass_matrix",
       {{"q"},
        Result::symmetric_matrix,
        Gravity::none,
        "Symmetric, positive definite M(q), by composite bodies in base parameters; rotors included."}},
      {"coriolis_matrix",
       {{"q", "qd"},
        Result::matrix,
        Gravity::none,
        "C(q, qd) of Christoffel's symbols: C qd is coriolis_torque, dM/dt - 2 C is skew-symmetric."}},
      {"forward_dynamics",
       {{"q", "qd", "torque"},
        Result::vector,
        Gravity::magnitude,
        "Joint accelerations for given joint forces: M qdd = torque - C qd - gravity, by M = U D U^T."}},
      {"momentum_matrix",
       {{"q"},
        Result::momentum_matrix,
        Gravity::none,
        "Momentum, linear and angular about the base's origin, in the base's own frame, by velocities: the\n"
        "first six rows of the mass matrix. Centroidal (centroidal.h) makes of it what concerns the centre "
        "of\n"
        "mass."}},
      {"kinetic_energy", {{"q", "qd"}, Result::scalar, Gravity::none, "qd^T M qd / 2, J."}},
      {"potential_energy",
       {{"q"},
        Result::scalar,
        Gravity::magnitude,
        "Sum of m g z over the links, z of the centre of mass in the world, J."}},
      {"centre_of_mass",
       {{"q"}, Result::point, Gravity::none, "Centre of mass of all links in the world frame, m."}},
      {"centre_of_mass_jacobian",
       {{"q"},
        Result::point_derivatives,
        Gravity::none,
        "Its derivatives by the joints: the centre of mass moves with centre_of_mass_jacobian(q) qd."}},
      {"regressor",
       {{"q", "qd", "qdd"},
        Result::regressor,
        Gravity::magnitude,
        "Y with inverse_dynamics = Y base_parameters for all inertias, without drives. `inertia` has no "
        "influence."}},
      {"regressor_with_drives",
       {{"q", "qd", "qdd"},
        Result::drive_regressor,
        Gravity::magnitude,
        "Y with inverse_dynamics = Y identifiable_parameters for all inertias and drives. `inertia` has no "
        "influence."}},
      {"inverse_dynamics_derivatives",
       {{"q", "qd", "qdd"},
        Result::derivatives,
        Gravity::magnitude,
        "Joint forces for a motion, and their derivatives by q and qd; the one by qdd is mass_matrix."}},
      {"inverse_dynamics_with_gravity_vector",
       {{"q", "qd", "qdd"},
        Result::vector,
        Gravity::vector,
        "Joint forces for a motion, under gravity in any direction.",
        "inverse_dynamics"}},
      {"inverse_dynamics_with_wrench",
       {{"q", "qd", "qdd"},
        Result::vector,
        Gravity::vector,
        "Joint forces for a motion while a wrench acts on the tool from outside: those without it minus "
        "jacobian(q)^T wrench.",
        "inverse_dynamics",
        true}},
      {"gravity_torque_with_gravity_vector",
       {{"q"},
        Result::vector,
        Gravity::vector,
        "Joint forces that hold the robot at rest, under gravity in any direction.",
        "gravity_torque"}},
      {"forward_dynamics_with_gravity_vector",
       {{"q", "qd", "torque"},
        Result::vector,
        Gravity::vector,
        "Joint accelerations for given joint forces, under gravity in any direction.",
        "forward_dynamics"}},
      {"forward_dynamics_with_wrench",
       {{"q", "qd", "torque"},
        Result::vector,
        Gravity::vector,
        "Joint accelerations for given joint forces while a wrench acts on the tool from outside.",
        "forward_dynamics",
        true}},
      {"potential_energy_with_gravity_vector",
       {{"q"},
        Result::scalar,
        Gravity::vector,
        "Minus the sum of m gravity . r over the links, r the centre of mass in the world, J.",
        "potential_energy"}},
  };
  return known;
}

}  // namespace

DynamicsInterface dynamics_interface(const std::string& name) { return known_interfaces().at(name); }

bool is_dynamics_function(const std::string& name) { return known_interfaces().count(name) > 0; }

std::string type_of(Result result, const std::string& scalar, bool floats) {
  const std::string size = floats ? "velocity_size" : "dof";
  switch (result) {
    case Result::scalar:
      return scalar;
    case Result::vector:
      return (floats ? "Velocity<" : "JointVector<") + scalar + ">";
    case Result::symmetric_matrix:
    case Result::matrix:
      return "Eigen::Matrix<" + scalar + ", " + size + ", " + size + ">";
    case Result::momentum_matrix:
      return "Eigen::Matrix<" + scalar + ", 6, " + size + ">";
    case Result::regressor:
      return "Eigen::Matrix<" + scalar + ", " + size + ", base_parameter_count>";
    case Result::drive_regressor:
      return "Eigen::Matrix<" + scalar + ", " + size + ", identifiable_parameter_count>";
    case Result::derivatives:
      return "InverseDynamicsDerivatives<" + scalar + ">";
    case Result::point:
      return "Eigen::Matrix<" + scalar + ", 3, 1>";
    case Result::point_derivatives:
      return "Eigen::Matrix<" + scalar + ", 3, dof>";
  }
  return {};
}

namespace {

std::string entry(const std::string& matrix, std::size_t row, std::size_t column) {
  return matrix + "(" + std::to_string(row) + ", " + std::to_string(column) + ")";
}

std::vector<std::string> vector_places(const std::string& vector, std::size_t size) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < size; ++i) places.push_back(vector + "[" + std::to_string(i) + "]");
  return places;
}

std::vector<std::string> places_by_rows(std::size_t rows, std::size_t columns) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < columns; ++k) places.push_back(entry("result", i, k));
  return places;
}

std::vector<std::string> places_by_columns(const std::string& matrix, std::size_t rows, std::size_t columns) {
  std::vector<std::string> places;
  for (std::size_t k = 0; k < columns; ++k)
    for (std::size_t i = 0; i < rows; ++i) places.push_back(entry(matrix, i, k));
  return places;
}

std::vector<std::string> symmetric_places(std::size_t size) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < size; ++i) {
    places.push_back(entry("result", i, i));
    for (std::size_t k = i + 1; k < size; ++k)
      places.push_back(entry("result", i, k) + " = " + entry("result", k, i));
  }
  return places;
}

std::vector<std::string> derivative_places(std::size_t dof) {
  std::vector<std::string> places = vector_places("result.torque", dof);
  for (std::size_t k = 0; k < dof; ++k)
    for (const char* matrix : {"result.by_position", "result.by_rate"})
      for (std::size_t i = 0; i < dof; ++i) places.push_back(entry(matrix, i, k));
  return places;
}

}  // namespace

std::vector<std::string> places_of(Result result, std::size_t dof, std::size_t count) {
  switch (result) {
    case Result::scalar:
      return {"result"};
    case Result::vector:
      return vector_places("result", dof);
    case Result::symmetric_matrix:
      return symmetric_places(dof);
    case Result::matrix:
      return places_by_rows(dof, dof);
    case Result::momentum_matrix:
      return places_by_rows(6, dof);
    case Result::regressor:
    case Result::drive_regressor:
      return places_by_columns("result", dof, count / dof);
    case Result::derivatives:
      return derivative_places(dof);
    case Result::point:
      return vector_places("result", 3);
    case Result::point_derivatives:
      return places_by_columns("result", 3, dof);
  }
  return {};
}

}  // namespace qvgen::emit
