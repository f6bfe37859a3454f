// SPDX-License-Identifier: MIT
#include "pipeline/products/page.h"

#include "canonical/right_angles.h"
#include "emit/c/parts.h"
#include "optimise/described.h"
#include "optimise/pose.h"
#include "pipeline/c_files.h"
#include "pipeline/products/inverse.h"
#include "pipeline/products/jacobian_functions.h"
#include "pipeline/products/model_header.h"

namespace qvgen::pipeline {
namespace {

void generate_pose_c(const model::Robot& described, RobotOutput& output) {
  optimise::OptimiseOptions options;
  options.also_fewest = false;  // a count that a page has from elsewhere
  optimise::Pose pose = optimise::forward_kinematics(described, options);
  const auto function = optimise::in_terms_of_description(std::move(pose.function), pose.arm);
  add_c_part(output, emit::c::pose(pose.arm.robot, function, {}));
}

void generate_plain_jacobian_c(const model::Robot& described, RobotOutput& output) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  auto [measures, measures_function] = singularity_measures_function(arm.robot, output);
  measures_function.optimised =
      optimise::in_terms_of_description(std::move(measures_function.optimised), arm);
  const canonical::Arm own = canonical::whatever_notation(described);
  emit::JacobianFunction jacobian = plain_jacobian_function(own.robot);
  jacobian.optimised = optimise::in_terms_of_description(std::move(jacobian.optimised), own);
  output.counts["measures"] = measures.names;
  add_c_part(output, emit::c::jacobian(arm.robot, {jacobian, measures_function}));
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
