// SPDX-License-Identifier: MIT
// Pinocchio's own loops, of its headers alone, so that they have the flags of what they are compared with.
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

void store(const Eigen::MatrixXd& value, double* result, int place = 0) {
  Eigen::Map<Eigen::MatrixXd>(result + place * model.nv * model.nv, model.nv, value.cols()) = value;
}
void store_vector(const Vector& value, double* result) { Eigen::Map<Vector>(result, model.nv) = value; }

void inverse_dynamics(std::size_t k, double* result) {
  const Motion& m = motions[k];
  store_vector(pinocchio::rnea(model, *data, m.q, m.v, m.a), result);
}
void mass_matrix(std::size_t k, double* result) {
  store(pinocchio::crba(model, *data, motions[k].q, pinocchio::Convention::WORLD), result);
}
void forward_dynamics(std::size_t k, double* result) {
  const Motion& m = motions[k];
  store_vector(pinocchio::aba(model, *data, m.q, m.v, m.a, pinocchio::Convention::LOCAL), result);
}
void inverse_derivatives(std::size_t k, double* result) {
  const Motion& m = motions[k];
  pinocchio::computeRNEADerivatives(model, *data, m.q, m.v, m.a);
  store(data->dtau_dq, result);
  store(data->dtau_dv, result, 1);
}
void forward_derivatives(std::size_t k, double* result) {
  const Motion& m = motions[k];
  pinocchio::computeABADerivatives(model, *data, m.q, m.v, m.a);
  store(data->ddq_dq, result);
  store(data->ddq_dv, result, 1);
  store(data->Minv, result, 2);
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
  return {"Pinocchio",
          {inverse_dynamics, mass_matrix, forward_dynamics, inverse_derivatives, forward_derivatives},
          place};
}

}  // namespace qvgen::benchmark::trees
