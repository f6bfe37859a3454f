// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <mujoco/mujoco.h>

#include "reference/chain.h"

namespace comparison {

/// An arm in MuJoCo, with contacts and constraints off, as few bodies as it has joints and the inertias of
/// the description. Each function calls no more of MuJoCo's stages than it needs. A result is a pointer to
/// MuJoCo's numbers, valid until the next call.
class MujocoArm {
 public:
  explicit MujocoArm(const reference::Chain& chain);

  const double* inverse_dynamics(const double* q, const double* qd, const double* qdd);     ///< n
  const double* mass_matrix(const double* q);                                               ///< n x n
  const double* forward_dynamics(const double* q, const double* qd, const double* torque);  ///< n

 private:
  void set(const double* q);

  struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::size_t n_;
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  std::vector<double> force_, result_;
};

}  // namespace comparison
