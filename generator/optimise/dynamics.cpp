// SPDX-License-Identifier: MIT
#include "optimise/dynamics.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "canonical/right_angles.h"
#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "model/coordinates.h"
#include "model/evaluate.h"
#include "optimise/coriolis_laws.h"
#include "optimise/described.h"
#include "passes/search/search.h"
#include "verify/some_given.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::Formulation;
using derive::dynamics::FormulationOptions;
using exact::Number;

constexpr std::size_t most_units = 6;
/// Robots with more joints try no choices: each trial is a search of its own.
constexpr std::size_t most_joints_with_trials = 8;

/// More than any chain has. Functions of larger robots have ten thousand values: pairs of all are too many.
constexpr std::size_t most_coordinates_with_long_search = 16;

OptimiseOptions short_search(OptimiseOptions options) {
  options.search.closure = false;
  options.search.iterations = std::min(options.search.iterations, 200'000L);
  options.search.restarts = 1;
  options.more_steps = 0;
  return options;
}

int operations(const dag::OperationCounts& counts) {
  constexpr int division = 4;
  return counts.multiplications + counts.additions + division * counts.divisions;
}

/// Keeps the choices whose formulation a short search makes the cheapest.
class Trials {
 public:
  Trials(const model::Robot& robot, const DynamicsQuantity& quantity, long steps)
      : robot_(robot), quantity_(quantity), is_free_(free_symbols(robot)) {
    options_.iterations = steps;
    options_.restarts = 1;
    options_.is_free_symbol = is_free_;
  }

  void consider(const FormulationOptions& choices) {
    const Formulation formulation = quantity_.formulate(robot_, choices);
    const int found = operations(dag::count(passes::search({formulation.function}, {}, options_), is_free_));
    if (best_ && found >= fewest_) return;
    best_ = choices;
    fewest_ = found;
  }
  [[nodiscard]] const FormulationOptions& best() const { return *best_; }
  [[nodiscard]] int fewest() const { return fewest_; }

 private:
  const model::Robot& robot_;
  const DynamicsQuantity& quantity_;
  dag::IsFree is_free_;
  passes::SearchOptions options_;
  std::optional<FormulationOptions> best_;
  int fewest_ = 0;
};

std::size_t unit_count(const model::Robot& robot) {
  dag::Graph graph;
  return std::min(most_units, unit_candidates(derive::dynamics::make_chain(robot, graph)).size());
}

void try_units(Trials& trials, const model::Robot& robot, bool unrotated) {
  const std::size_t units = unit_count(robot);
  for (std::size_t unit = 0; unit <= units; ++unit) {
    FormulationOptions choices;
    if (unit > 0) choices.convention.unit = unit - 1;
    choices.last_link_unrotated = unrotated;
    trials.consider(choices);
  }
}

FormulationOptions best_choices(const model::Robot& robot, const DynamicsQuantity& quantity, long steps) {
  if (robot.joints.size() > most_joints_with_trials || robot.floating_base) return {};
  Trials trials(robot, quantity, steps);
  try_units(trials, robot, true);
  if (quantity.has_wrenches) try_units(trials, robot, false);
  for (const auto& [link, component] : derive::dynamics::mass_shifts(robot)) {
    FormulationOptions choices = trials.best();
    choices.convention.masses[link] = component;
    trials.consider(choices);
  }
  return trials.best();
}

/// The arm whose inverse dynamics a short search makes the cheapest.
std::size_t cheapest(const std::vector<canonical::Arm>& arms, long steps) {
  std::size_t best = 0;
  int fewest = 0;
  for (std::size_t i = 0; i < arms.size() && arms.size() > 1; ++i) {
    Trials trials(arms[i].robot, dynamics_quantities().front(), steps);
    try_units(trials, arms[i].robot, true);
    if (i > 0 && trials.fewest() >= fewest) continue;
    best = i;
    fewest = trials.fewest();
  }
  return best;
}

}  // namespace

dag::IsFree free_symbols(const model::Robot& robot) {
  std::set<std::string> moving;
  const auto add = [&](const std::string& variable) {
    for (const std::string& name :
         {variable, derive::dynamics::velocity_of(variable), derive::dynamics::acceleration_of(variable),
          derive::dynamics::force_of(variable), derive::dynamics::direction_of(variable)})
      moving.insert(name);
  };
  for (const model::Joint& joint : robot.joints) add(joint.variable);
  for (const model::Motor& motor : robot.motors) add(motor.variable);
  for (std::size_t k = 0; k < 6; ++k) moving.insert(derive::dynamics::wrench_component(k));
  for (std::size_t k = 0; k < model::base_motions(robot); ++k) {
    const std::string name = model::base_coordinate(k);
    moving.merge(std::set{derive::dynamics::velocity_of(name), derive::dynamics::acceleration_of(name),
                          derive::dynamics::force_of(name)});
  }
  for (std::size_t k = 0; robot.floating_base && k < 4; ++k)
    moving.insert(derive::dynamics::gravity_component(k));
  return [moving](const std::string& name) { return !moving.contains(name); };
}

DynamicsModel dynamics_model(const model::Robot& described, const DynamicsEffort& effort) {
  std::vector<canonical::Arm> arms = canonical::whatever_notation_with_links(described);
  return {std::move(arms[cheapest(arms, effort.trial_steps)]), canonical::for_dynamics(described)};
}

Quantity quantity_of(const DynamicsModel& model, const std::string& name, const Formulation& formulation,
                     const verify::Residuals& residuals) {
  const model::Robot& robot = model.arm.robot;
  Quantity quantity{name, {{"", formulation.function}}, residuals};
  quantity.constants = formulation.constants;
  quantity.is_free = free_symbols(robot);
  // Dynamics knows no half angles of joints.
  for (const model::Joint& joint : robot.joints) quantity.whole.insert(joint.variable);
  quantity.in_terms_of_description = [arm = model.arm](const dag::Function& function) {
    return dynamics_in_terms_of_description(function, arm);
  };
  return quantity;
}

OptimiseOptions final_search(const DynamicsEffort& effort) {
  OptimiseOptions options;
  options.search = {};
  options.search.iterations = effort.final_steps;
  options.more_steps = effort.trial_steps;
  options.certificate_points = effort.certificate_points;
  options.also_fewest = false;
  options.simplify_forms = false;
  return options;
}

std::optional<dag::Function> with_default_values(const model::Robot& robot, const Optimised& function) {
  std::map<std::string, Number> values{
      {derive::dynamics::gravity_symbol, Number(cln::cl_RA(980665) / 100000)},
      {derive::dynamics::gravity_component(0), 3},
      {derive::dynamics::gravity_component(1), -4},
      {derive::dynamics::gravity_component(2), -8}};
  for (const auto& [name, value] : model::default_bindings(robot))
    if (const auto rational = model::rational_value(value)) values.emplace(name, Number(*rational));
  const auto known = [&](const dag::Function& f) {
    for (const std::uint32_t id : dag::reachable(f))
      if (f.graph.node(id).op == dag::Op::symbol && !values.contains(f.graph.symbol_of(f.graph.node(id))))
        return false;
    return true;
  };
  if (!known(function.constants)) return std::nullopt;
  const exact::ExactPoint point(1);
  const auto constants = dag::evaluate<Number>(function.constants, verify::SomeGiven{point, values});
  std::map<std::string, Number> numbers;
  for (std::size_t i = 0; i < constants.size(); ++i)
    numbers[function.constants.outputs[i].name] = constants[i];
  return dag::rebuild(function.function, [&](const dag::Graph& from, const dag::Node& node,
                                             const std::vector<dag::Edge>& operands, dag::Graph& to) {
    if (node.op == dag::Op::sum || node.op == dag::Op::product) return to.as_is(node.op, operands);
    const bool constant = node.op == dag::Op::symbol && numbers.contains(from.symbol_of(node));
    return constant ? to.constant(numbers.at(from.symbol_of(node)))
                    : dag::copy_node(from, node, operands, to);
  });
}

bool has_inertia(const model::Robot& robot) {
  const auto heavy = [](const model::Inertia& inertia) {
    const auto& i = inertia.inertia;
    return !inertia.mass.is_literal_zero() ||
           !std::all_of(i.begin(), i.end(), [](const model::Expression& e) { return e.is_literal_zero(); });
  };
  return (robot.floating_base && heavy(*robot.floating_base)) ||
         std::any_of(robot.joints.begin(), robot.joints.end(),
                     [&](const model::Joint& joint) { return heavy(joint.inertia); });
}

Optimised generate_dynamics(const DynamicsModel& model, const DynamicsQuantity& quantity,
                            const DynamicsEffort& effort) {
  const model::Robot& robot = model.arm.robot;
  const FormulationOptions choices =
      effort.choices ? *effort.choices : best_choices(robot, quantity, effort.trial_steps);
  const bool by_laws = robot.floating_base && quantity.name == "coriolis_matrix";
  const auto residuals = [&](const exact::ExactPoint& point, const std::vector<Number>& values) {
    if (by_laws) return residuals_of_coriolis_laws(model.described, point, values);
    return quantity.residuals(derive::dynamics::PlainRecursion(model.described, point), point, values);
  };
  const Formulation formulation = quantity.formulate(robot, choices);
  OptimiseOptions options = final_search(effort);
  options.search.restarts = 2;
  const bool is_large = model::coordinate_count(robot) > most_coordinates_with_long_search;
  if (is_large) options = short_search(options);
  Quantity competing = quantity_of(model, quantity.name, formulation, residuals);
  if (is_large && quantity.of_large_robots)
    if (const auto other = quantity.of_large_robots(robot, choices))
      competing.forms.push_back({"", other->function});
  Optimised result = optimise(competing, options);
  result.choices = choices;
  return result;
}

}  // namespace qvgen::optimise
