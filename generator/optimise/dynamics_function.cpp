// SPDX-License-Identifier: MIT
#include "optimise/dynamics_function.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "model/evaluate.h"
#include "passes/constant_split.h"
#include "passes/search/search.h"
#include "verify/certificate.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::Formulation;
using derive::dynamics::FormulationOptions;
using exact::Number;

constexpr std::size_t most_units = 6;

int operations(const dag::OperationCounts& counts) {
  constexpr int division = 4;
  return counts.multiplications + counts.additions + division * counts.divisions;
}

/// One combination of choices with what came of it.
struct Candidate {
  FormulationOptions choices;
  Formulation formulation;
  dag::Function found;
  dag::OperationCounts counts;
};

class Trials {
 public:
  Trials(const model::Robot& robot, const DynamicsQuantity& quantity)
      : robot_(robot), quantity_(quantity), is_free_(free_symbols(robot)) {}

  Candidate run(const FormulationOptions& choices, long steps, int restarts) {
    Candidate result{choices, quantity_.formulate(robot_, choices), {}, {}};
    passes::SearchOptions options;
    options.iterations = steps;
    options.restarts = restarts;
    options.is_free_symbol = is_free_;
    result.found = passes::search({result.formulation.function}, {}, options);
    result.counts = dag::count(result.found, is_free_);
    return result;
  }
  void consider(const FormulationOptions& choices, long steps) {
    Candidate candidate = run(choices, steps, 1);
    if (!best_ || operations(candidate.counts) < operations(best_->counts)) best_ = std::move(candidate);
  }
  [[nodiscard]] const FormulationOptions& best() const { return best_->choices; }
  [[nodiscard]] const dag::IsFree& is_free() const { return is_free_; }

 private:
  const model::Robot& robot_;
  const DynamicsQuantity& quantity_;
  dag::IsFree is_free_;
  std::optional<Candidate> best_;
};

std::size_t unit_count(const model::Robot& robot) {
  dag::Graph graph;
  return std::min(most_units, unit_candidates(derive::dynamics::make_chain(robot, graph)).size());
}

void try_choices(const model::Robot& robot, const DynamicsQuantity& quantity, Trials& trials, long steps) {
  const std::size_t units = unit_count(robot);
  for (std::size_t unit = 0; unit <= units; ++unit)
    for (const bool unrotated : {true, false}) {
      if (!unrotated && !quantity.has_wrenches) continue;
      FormulationOptions choices;
      if (unit > 0) choices.convention.unit = unit - 1;
      choices.last_link_unrotated = unrotated;
      trials.consider(choices, steps);
    }
  for (const auto& [link, component] : derive::dynamics::mass_shifts(robot)) {
    FormulationOptions choices = trials.best();
    choices.convention.masses[link] = component;
    trials.consider(choices, steps);
  }
}

/// Leaves of the split function at an exact point: "$i" are values of the set-up part.
struct WithConstants {
  const exact::ExactPoint& point;
  std::map<std::string, Number> constants;

  [[nodiscard]] Number constant(const Number& value) const { return value; }
  [[nodiscard]] Number symbol(const std::string& name) const {
    const auto place = constants.find(name);
    return place != constants.end() ? place->second : point.symbol(name);
  }
  [[nodiscard]] Number sine(const dag::Angle& angle) const { return point.sine(angle); }
  [[nodiscard]] Number cosine(const dag::Angle& angle) const { return point.cosine(angle); }
  [[nodiscard]] Number root(const Number& value) const { return point.root(value); }
  [[nodiscard]] Number arctangent(const Number& y, const Number& x) const { return point.arctangent(y, x); }
};

}  // namespace

dag::IsFree free_symbols(const model::Robot& robot) {
  std::set<std::string> moving;
  for (const model::Joint& joint : robot.joints)
    for (const std::string& name :
         {joint.variable, derive::dynamics::velocity_of(joint.variable),
          derive::dynamics::acceleration_of(joint.variable), derive::dynamics::force_of(joint.variable),
          derive::dynamics::direction_of(joint.variable)})
      moving.insert(name);
  for (std::size_t k = 0; k < 6; ++k) moving.insert(derive::dynamics::wrench_component(k));
  return [moving](const std::string& name) { return !moving.contains(name); };
}

void certify(const model::Robot& robot, DynamicsFunction& function, int points,
             const std::function<std::vector<Number>(const exact::ExactPoint&, const std::vector<Number>&)>&
                 residuals) {
  // Dynamics knows no half angles of joints.
  std::set<std::string> turns;
  for (const model::Joint& joint : robot.joints) turns.insert(joint.variable);
  for (int k = 0; k < points; ++k) {
    const exact::ExactPoint point(static_cast<std::uint64_t>(k) + 1, turns);
    WithConstants leaves{point, {}};
    const auto constants = dag::evaluate<Number>(function.constants, point);
    for (std::size_t i = 0; i < constants.size(); ++i)
      leaves.constants[function.constants.outputs[i].name] = constants[i];
    const auto rest = residuals(point, dag::evaluate<Number>(function.function, leaves));
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (!exact::agree(rest[i], 0))
        throw verify::CertificateError(function.name + ": output " + function.function.outputs.at(i).name +
                                       " differs from the plain recursion");
  }
  function.certified_points = points;
}

std::optional<dag::Function> with_default_values(const model::Robot& robot,
                                                 const DynamicsFunction& function) {
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
  const auto constants = dag::evaluate<Number>(function.constants, WithConstants{point, values});
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
  const auto heavy = [](const model::Joint& joint) {
    const auto& i = joint.inertia.inertia;
    return !joint.inertia.mass.is_literal_zero() ||
           !std::all_of(i.begin(), i.end(), [](const model::Expression& e) { return e.is_literal_zero(); });
  };
  return std::any_of(robot.joints.begin(), robot.joints.end(), heavy);
}

DynamicsFunction generate_dynamics(const model::Robot& robot, const DynamicsQuantity& quantity,
                                   const DynamicsEffort& effort) {
  Trials trials(robot, quantity);
  if (!effort.choices) try_choices(robot, quantity, trials, effort.trial_steps);
  constexpr int restarts = 2;
  const Candidate best =
      trials.run(effort.choices ? *effort.choices : trials.best(), effort.final_steps, restarts);
  const passes::ConstantSplit parts =
      passes::split_constants(best.found, best.formulation.constants, trials.is_free());
  DynamicsFunction result;
  result.name = quantity.name;
  result.function = parts.function;
  result.constants = parts.constants;
  result.counts = best.counts;
  result.constant_counts = dag::count(parts.constants);
  result.chosen = best.choices;
  certify(robot, result, effort.certificate_points,
          [&](const exact::ExactPoint& point, const std::vector<Number>& values) {
            return quantity.residuals(derive::dynamics::PlainRecursion(robot, point), point, values);
          });
  return result;
}

}  // namespace qvgen::optimise
