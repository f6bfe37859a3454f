// SPDX-License-Identifier: MIT
// Writes C by CasADi of Pinocchio's algorithms, as cheap as they are: write_casadi MODEL FOLDER makes
// FOLDER/peer.c. Results are dense matrices, for so are those of the others.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/autodiff/casadi.hpp>

#include "model.h"

namespace {

using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;

Vector entries(const SX& symbols) {
  Vector result(symbols.size1());
  for (Eigen::Index k = 0; k < result.size(); ++k) result[k] = symbols(k);
  return result;
}

template <class Matrix>
SX dense(const Matrix& values) {
  SX result = SX::zeros(values.rows(), values.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index j = 0; j < values.cols(); ++j) result(i, j) = values(i, j);
  return casadi::SX::densify(result);
}

}  // namespace

int main(int, char** arguments) {
  const pinocchio::Model of_numbers = qvgen::benchmark::trees::read_model(arguments[1]);
  const auto model = of_numbers.cast<SX>();
  pinocchio::DataTpl<SX> data(model);
  const SX q = SX::sym("q", model.nq), v = SX::sym("v", model.nv), a = SX::sym("a", model.nv);
  const Vector at = entries(q), qd = entries(v), qdd = entries(a);
  casadi::Dict options;
  options["with_header"] = false;
  casadi::CodeGenerator code("peer.c", options);
  const auto add = [&](const std::string& name, const std::vector<SX>& results) {
    code.add(casadi::Function(name, {q, v, a}, results));
  };
  add("peer_id", {dense(pinocchio::rnea(model, data, at, qd, qdd))});
  data.M.setZero();
  add("peer_m", {dense(pinocchio::crba(model, data, at, pinocchio::Convention::WORLD))});
  add("peer_fd", {dense(pinocchio::aba(model, data, at, qd, qdd, pinocchio::Convention::LOCAL))});
  pinocchio::computeRNEADerivatives(model, data, at, qd, qdd);
  add("peer_did", {dense(data.dtau_dq), dense(data.dtau_dv)});
  pinocchio::computeABADerivatives(model, data, at, qd, qdd);
  add("peer_dfd", {dense(data.ddq_dq), dense(data.ddq_dv), dense(data.Minv)});
  code.generate(std::string(arguments[2]) + "/");
  return 0;
}
