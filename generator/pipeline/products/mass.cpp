// SPDX-License-Identifier: MIT
#include "pipeline/products/mass.h"

#include <algorithm>

#include "emit/c/parts.h"
#include "emit/cpp/dynamics_code.h"
#include "emit/template_values.h"
#include "optimise/dynamics.h"
#include "pipeline/c_files.h"
#include "pipeline/products/dynamics_functions.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

bool has_mass(const model::Robot& described, RobotOutput& output) {
  const auto& joints = described.joints;
  if (described.floating_base && !described.floating_base->mass.is_literal_zero()) return true;
  if (std::any_of(joints.begin(), joints.end(),
                  [](const model::Joint& joint) { return !joint.inertia.mass.is_literal_zero(); }))
    return true;
  output.missing.push_back({"mass", Missing::Kind::not_described, "the description gives no mass"});
  return false;
}

/// The functions, certified, and the arm that they are of.
struct Functions {
  model::Robot robot;
  std::vector<optimise::Optimised> list;
};

Functions functions_of(const model::Robot& described) {
  const optimise::DynamicsModel model = optimise::dynamics_model(described);
  Functions result{model.arm.robot, {}};
  optimise::DynamicsEffort effort;
  effort.choices.emplace();
  for (const optimise::DynamicsQuantity& quantity : optimise::mass_quantities(model.described)) {
    optimise::Optimised function = generate_dynamics(model, quantity, effort);
    function.choices.reset();
    measure(result.robot, function);
    result.list.push_back(in_terms_of_leaders(result.robot, std::move(function)));
  }
  return result;
}

}  // namespace

void generate_mass(const model::Robot& described, RobotOutput& output) {
  if (!has_mass(described, output)) return;
  if (described.floating_base) {
    output.missing.push_back({"mass", Missing::Kind::not_described,
                              "the base floats: qvgen/centroidal.h has mass and centre, by momentum_matrix"});
    return;
  }
  const auto [robot, functions] = functions_of(described);
  const emit::Code mass = emit::total_mass_code(robot);
  const json values{{"total_mass", mass.outputs.front().expression},
                    {"mass_temporaries", emit::values_of(mass.temporaries)}};
  add_functions(robot, functions, "mass", "MassAngles", values, output);
}

void generate_mass_c(const model::Robot& described, RobotOutput& output) {
  if (!has_mass(described, output)) return;
  if (described.floating_base) {
    const model::Robot robot = optimise::dynamics_model(described).arm.robot;
    add_c_part(output, emit::c::total_mass(robot));
    return add_c_part(output, emit::c::centroidal(robot));
  }
  const auto [robot, functions] = functions_of(described);
  add_c_part(output, emit::c::total_mass(robot));
  add_c_part(output, emit::c::dynamics(robot, functions));
  for (const optimise::Optimised& function : functions)
    output.counts[function.name] = entry_of(robot, function);
}

}  // namespace qvgen::pipeline
