// SPDX-License-Identifier: MIT
#include "application/products/product.h"

#include "application/products/dynamics.h"
#include "application/products/inverse.h"
#include "application/products/jacobian.h"
#include "application/products/kinematics.h"
#include "application/products/model_header.h"

namespace qvgen::application {

const std::vector<Product>& all_products() {
  static const std::vector<Product> products{{"model", generate_model_header},
                                             {"kinematics", generate_kinematics},
                                             {"inverse", generate_inverse},
                                             {"jacobian", generate_jacobian},
                                             {"dynamics", generate_dynamics_product}};
  return products;
}

}  // namespace qvgen::application
