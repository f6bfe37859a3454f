// SPDX-License-Identifier: MIT
#include "pipeline/products/product.h"

#include "pipeline/products/dynamics.h"
#include "pipeline/products/inverse.h"
#include "pipeline/products/jacobian.h"
#include "pipeline/products/kinematics.h"
#include "pipeline/products/model_header.h"

namespace qvgen::pipeline {

const std::vector<Product>& all_products() {
  static const std::vector<Product> products{
      {"model", generate_model_header},
      {"kinematics", generate_kinematics},
      {"inverse", generate_inverse},
      {"jacobian", generate_jacobian, {}, {"singularity_measures"}},
      {"dynamics",
       generate_dynamics_product,
       {"dynamics_derivatives", "dynamics_loads", "regressor"},
       {"forward_dynamics", "forward_dynamics_with_gravity_vector", "forward_dynamics_with_wrench"}}};
  return products;
}

}  // namespace qvgen::pipeline
