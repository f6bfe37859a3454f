// SPDX-License-Identifier: MIT
// Generated functions of the robot ROBOT, as programs that use them call them.
#include <algorithm>
#include <new>

#include <qvgen/forward_dynamics_derivatives.h>

#include "implementation.h"
#include QVGEN_DYNAMICS
#include QVGEN_DERIVATIVES

namespace qvgen::benchmark::trees {
namespace {

namespace robot = qvgen::robots::QVGEN_ROBOT;

#if QVGEN_FLOATING
constexpr int size = robot::velocity_size;
using At = robot::Configuration<double>;
constexpr auto parents = robot::mass_matrix_parents;
#else
constexpr int size = robot::dof;
using At = robot::JointVector<double>;
constexpr Chain<size> parents{};
#endif
using Vector = Eigen::Matrix<double, size, 1>;
using Matrix = Eigen::Matrix<double, size, size>;

struct Motion {
  At at;
  Vector qd, qdd;
};
std::vector<Motion> motions;

Motion motion(const State& state, const std::vector<std::size_t>& place) {
  Motion m;
  for (std::size_t k = 0; k < size; ++k) {
    const auto here = static_cast<Eigen::Index>(place[k]);
    m.qd[here] = state.v[k];
    m.qdd[here] = state.a[k];
#if QVGEN_FLOATING
    if (k >= 6) m.at.q[here - 6] = state.q[k + 1];
#else
    m.at[here] = state.q[k];
#endif
  }
#if QVGEN_FLOATING
  const auto& q = state.q;
  m.at.base = {Eigen::Quaterniond(q[6], q[3], q[4], q[5]), {q[0], q[1], q[2]}};
#endif
  return m;
}

std::vector<std::size_t> places(const Robot& robot) {
  std::vector<std::size_t> result;
  const std::size_t base = robot.floating ? 6 : 0;
  for (std::size_t k = 0; k < base; ++k) result.push_back(k);
  const auto& ours = robot::joint_names;
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    const auto found = std::find(ours.begin(), ours.end(), robot.joints[k]);
    // Names of an arm's joints are those of its own description, in the order of the chain.
    result.push_back(base + (found == ours.end() ? k : static_cast<std::size_t>(found - ours.begin())));
  }
  return result;
}

/// Room for what a function returns, which is constructed there, as it is in a variable of a program.
template <class Result>
struct Room {
  template <class Function>
  void take(const Function& function) {
    new (bytes) Result(function());
  }
  const Result& result() const { return *std::launder(reinterpret_cast<const Result*>(bytes)); }
  alignas(Result) unsigned char bytes[sizeof(Result)];
};
using Derivatives = robot::InverseDynamicsDerivatives<double>;
using ForwardDerivatives = ForwardDynamicsDerivatives<double, size>;
Room<Vector> forces, accelerations;
Room<Matrix> mass;
Room<Derivatives> of_forces;
Room<ForwardDerivatives> of_accelerations;

/// Copies vectors or matrices one behind the other.
template <class... Values>
void copy(double* result, const Values&... values) {
  ((result = std::copy(values.data(), values.data() + values.size(), result)), ...);
}

void inverse_dynamics(std::size_t k) {
  const Motion& m = motions[k];
  forces.take([&] { return robot::inverse_dynamics(m.at, m.qd, m.qdd); });
}
void mass_matrix(std::size_t k) {
  mass.take([&] { return robot::mass_matrix(motions[k].at); });
}
void forward_dynamics(std::size_t k) {
  const Motion& m = motions[k];
  accelerations.take([&] { return robot::forward_dynamics(m.at, m.qd, m.qdd); });
}
void inverse_derivatives(std::size_t k) {
  const Motion& m = motions[k];
  of_forces.take([&] { return robot::inverse_dynamics_derivatives(m.at, m.qd, m.qdd); });
}
#if QVGEN_FLOATING
/// Sines and cosines are computed once.
struct Computed {
  explicit Computed(const Motion& motion) : m(motion), angles(robot::dynamics_angles(m.at.q)) {}
  auto mass() const { return robot::mass_matrix(m.at, angles, {}); }
  Vector forces(const Vector& qdd) const {
    return robot::inverse_dynamics(m.at, m.qd, qdd, gravity, angles, {});
  }
  auto derivatives(const Vector& qdd) const {
    return robot::inverse_dynamics_derivatives(m.at, m.qd, qdd, gravity, angles, {});
  }
  const Motion& m;
  robot::DynamicsAngles<double> angles;
  FreeFall<double> gravity = 9.80665;
};
#else
struct Computed {
  auto mass() const { return robot::mass_matrix(m.at); }
  Vector forces(const Vector& qdd) const { return robot::inverse_dynamics(m.at, m.qd, qdd); }
  auto derivatives(const Vector& qdd) const { return robot::inverse_dynamics_derivatives(m.at, m.qd, qdd); }
  const Motion& m;
};
#endif

void forward_derivatives(std::size_t k) {
  const Computed at{motions[k]};
  const BranchFactorisation factors(at.mass(), parents);
  const Vector qdd = factors.solve(motions[k].qdd - at.forces(Vector::Zero()));
  of_accelerations.take([&] { return forward_dynamics_derivatives(factors, at.derivatives(qdd)); });
}

}  // namespace

Implementation of_qvgen(const Robot& robot) {
  const std::vector<std::size_t> place = places(robot);
  for (const State& state : robot.states) motions.push_back(motion(state, place));
  return {"qvgen",
          {inverse_dynamics, mass_matrix, forward_dynamics, inverse_derivatives, forward_derivatives},
          {[](double* to) { copy(to, forces.result()); }, [](double* to) { copy(to, mass.result()); },
           [](double* to) { copy(to, accelerations.result()); },
           [](double* to) { copy(to, of_forces.result().by_position, of_forces.result().by_rate); },
           [](double* to) {
             const ForwardDerivatives& found = of_accelerations.result();
             copy(to, found.by_position, found.by_rate, found.by_torque);
           }},
          place};
}

}  // namespace qvgen::benchmark::trees
