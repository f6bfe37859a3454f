// SPDX-License-Identifier: MIT
// Pinocchio's own loops, of its headers alone, so that they have the flags of what they are compared with.
#include <algorithm>
#include <numeric>

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "implementation.h"
#include "model.h"

namespace qvgen::benchmark::trees {
namespace {

using pinocchio::Data;
using pinocchio::Model;
using Vector = Eigen::VectorXd;

struct Motion {
  Vector q, v, a;
};
Model model;
Data* data = nullptr;
std::vector<Motion> motions;

void inverse_dynamics(std::size_t k) {
  const Motion& m = motions[k];
  pinocchio::rnea(model, *data, m.q, m.v, m.a);
}
void mass_matrix(std::size_t k) { pinocchio::crba(model, *data, motions[k].q, pinocchio::Convention::WORLD); }
void forward_dynamics(std::size_t k) {
  const Motion& m = motions[k];
  pinocchio::aba(model, *data, m.q, m.v, m.a, pinocchio::Convention::LOCAL);
}
void inverse_derivatives(std::size_t k) {
  const Motion& m = motions[k];
  pinocchio::computeRNEADerivatives(model, *data, m.q, m.v, m.a);
}
void forward_derivatives(std::size_t k) {
  const Motion& m = motions[k];
  pinocchio::computeABADerivatives(model, *data, m.q, m.v, m.a);
}

/// Copies vectors or matrices one behind the other.
template <class... Values>
void copy(double* result, const Values&... values) {
  const auto add = [&](const Eigen::MatrixXd& value) {
    result = std::copy(value.data(), value.data() + value.size(), result);
  };
  (add(values), ...);
}

}  // namespace

Implementation of_pinocchio(const Robot& robot, const std::string& file) {
  model = read_model(file);
  static Data of_model(model);
  data = &of_model;
  const auto vector = [](const std::vector<double>& values) {
    return Vector(Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  for (const State& s : robot.states) motions.push_back({vector(s.q), vector(s.v), vector(s.a)});
  std::vector<std::size_t> place(robot.size);
  std::iota(place.begin(), place.end(), std::size_t{0});
  return {
      "Pinocchio",
      {inverse_dynamics, mass_matrix, forward_dynamics, inverse_derivatives, forward_derivatives},
      {[](double* to) { copy(to, data->tau); }, [](double* to) { copy(to, data->M); },
       [](double* to) { copy(to, data->ddq); }, [](double* to) { copy(to, data->dtau_dq, data->dtau_dv); },
       [](double* to) { copy(to, data->ddq_dq, data->ddq_dv, data->Minv); }},
      place};
}

}  // namespace qvgen::benchmark::trees
