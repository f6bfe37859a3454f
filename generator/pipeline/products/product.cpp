// SPDX-License-Identifier: MIT
#include "pipeline/products/product.h"

#include "pipeline/products/arm_angle.h"
#include "pipeline/products/batch.h"
#include "pipeline/products/c_inverse.h"
#include "pipeline/products/certified.h"
#include "pipeline/products/dynamics.h"
#include "pipeline/products/frames.h"
#include "pipeline/products/from_ideal.h"
#include "pipeline/products/geometry_jacobian.h"
#include "pipeline/products/given_joint.h"
#include "pipeline/products/inverse.h"
#include "pipeline/products/jacobian.h"
#include "pipeline/products/kinematics.h"
#include "pipeline/products/linuxcnc.h"
#include "pipeline/products/mass.h"
#include "pipeline/products/model_header.h"
#include "pipeline/products/moveit_plugin.h"
#include "pipeline/products/nearest_pose.h"
#include "pipeline/products/regressor_with_drives.h"

namespace qvgen::pipeline {

const std::vector<Product>& all_products() {
  static const std::vector<Product> products{
      {"model", generate_model_header, {}, {}, generate_model_c, false, {}, true},
      {"kinematics", generate_kinematics, {}, {}, generate_kinematics_c},
      {"inverse", generate_inverse, {}, {}, generate_inverse_c, false, {}, false},
      {"arm_angle", generate_arm_angle, {}, {}, generate_arm_angle_c},
      {"jacobian", generate_jacobian, {}, {"singularity_measures"}, generate_jacobian_c},
      {"from_ideal", generate_from_ideal, {}, {}, generate_from_ideal_c},
      {"dynamics",
       generate_dynamics_product,
       {model::requestable_parts.begin(), model::requestable_parts.end()},
       {"forward_dynamics", "forward_dynamics_with_gravity_vector", "forward_dynamics_with_wrench"},
       generate_dynamics_c,
       false,
       {},
       true},
      {"frames", generate_frames, {}, {}, generate_frames_c, true, {"kinematics"}},
      {"geometry_jacobian", generate_geometry_jacobian, {}, {}, generate_geometry_jacobian_c, true},
      {"mass", generate_mass, {}, {}, generate_mass_c, true, {"dynamics"}, true},
      {"regressor_with_drives",
       generate_regressor_with_drives,
       {},
       {},
       generate_regressor_with_drives_c,
       true,
       {"dynamics"},
       true}};
  return products;
}

const std::vector<Extra>& all_extras() {
  static const std::vector<Extra> extras{
      {"batch", {}, add_batch, true, true},
      {"c_inverse", {"inverse"}, add_c_inverse, false, true},
      {"certified", {"inverse"}, add_certified, false, true},
      {"moveit_plugin", {"kinematics", "inverse"}, add_moveit_plugin},
      {"given_joint", {"kinematics", "inverse", "jacobian"}, add_given_joint},
      {"nearest_pose", {"kinematics", "jacobian"}, add_nearest_pose, false, true},
      {"linuxcnc", {"kinematics", "inverse"}, add_linuxcnc, false, true, true}};
  return extras;
}

}  // namespace qvgen::pipeline
