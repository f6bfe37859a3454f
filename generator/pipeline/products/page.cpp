// SPDX-License-Identifier: MIT
#include "pipeline/products/page.h"

#include "derive/kinematics/forward_kinematics.h"
#include "emit/c/parts.h"
#include "optimise/described.h"
#include "pipeline/c_files.h"
#include "pipeline/products/inverse.h"
#include "pipeline/products/jacobian_functions.h"
#include "pipeline/products/model_header.h"
#include "verify/same_pose.h"

namespace qvgen::pipeline {
namespace {

void generate_pose_c(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  verify::certify_same_pose(described, arm);
  optimise::OptimiseOptions options;
  options.also_fewest = false;  // a count that a page has from elsewhere
  optimise::Optimised pose = optimise::optimise(derive::forward_kinematics(arm.robot), options);
  pose = optimise::in_terms_of_description(std::move(pose), arm);
  add_c_part(output, emit::c::pose(arm.robot, pose, {}));
}

void generate_plain_jacobian_c(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto [measures, measures_function] = singularity_measures_function(arm.robot, output);
  std::vector<emit::JacobianFunction> functions{plain_jacobian_function(arm.robot), measures_function};
  for (emit::JacobianFunction& function : functions)
    function.optimised = optimise::in_terms_of_description(std::move(function.optimised), arm);
  output.counts["measures"] = measures.names;
  add_c_part(output, emit::c::jacobian(arm.robot, functions));
}

}  // namespace

const std::vector<Product>& page_products() {
  static const std::vector<Product> products{{"model", nullptr, {}, {}, generate_model_c},
                                             {"kinematics", nullptr, {}, {}, generate_pose_c},
                                             {"inverse", nullptr, {}, {}, generate_inverse_c},
                                             {"jacobian", nullptr, {}, {}, generate_plain_jacobian_c}};
  return products;
}

}  // namespace qvgen::pipeline
