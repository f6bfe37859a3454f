// SPDX-License-Identifier: MIT
#include "optimise/dynamics_derivatives.h"

#include <algorithm>

#include "dag/evaluate.h"
#include "model/coordinates.h"
#include "model/followers.h"
#include "passes/differentiate.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::PlainRecursion;
using exact::ExactPoint;
using exact::Number;
using Values = std::vector<Number>;

/// To compute the torques, besides the emitted one.
constexpr std::uint64_t more_ways = 4;
/// Derivatives by the chain rule of larger robots cost twice those by composite bodies, and a long search.
constexpr std::size_t most_coordinates_by_chain_rule = 24;

Values combined(const Number& a, const Values& x, const Number& b, const Values& y) {
  Values result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(a * x[i] + b * y[i]);
  return result;
}

class Differences {
 public:
  Differences(const model::Robot& robot, const ExactPoint& point)
      : robot_(robot), point_(point), plain_(robot, point), load_(plain_.usual_load()) {}

  Values torques() const { return torques_under(load_); }
  /// (f(x + 1) - f(x - 1))/2 of a polynomial of degree two.
  Values by_rate(std::size_t joint) const {
    Values up = plain_.rates(), down = up;
    up[joint] = up[joint] + 1;
    down[joint] = down[joint] - 1;
    const Number half = Number(1) / Number(2);
    return combined(half, plain_.inverse_dynamics(up, plain_.accelerations(), load_), -half,
                    plain_.inverse_dynamics(down, plain_.accelerations(), load_));
  }
  /// By the joint and what follows it, or by a motion of the base: where it is makes no difference, and a
  /// turn is one of gravity the other way, in which forces are linear.
  Values by_position(std::size_t coordinate) const {
    const std::size_t base = model::base_motions(robot_);
    if (coordinate >= base) return by_joint(coordinate - base);
    if (coordinate < 3) return Values(plain_.size());
    const std::size_t k = coordinate - 3, i = (k + 1) % 3, j = (k + 2) % 3;
    PlainRecursion::Load turned = load_;
    turned.gravity[i] = turned.gravity[i] + load_.gravity[j];
    turned.gravity[j] = turned.gravity[j] - load_.gravity[i];
    return combined(1, torques_under(turned), -1, torques());
  }

 private:
  Values torques_under(const PlainRecursion::Load& load) const {
    return plain_.inverse_dynamics(plain_.rates(), plain_.accelerations(), load);
  }

  Values by_joint(std::size_t driven) const {
    Values sum(plain_.size());
    const std::vector<std::vector<model::Share>> shares = model::shares(robot_);
    for (std::size_t i = 0; i < shares.size(); ++i)
      for (const model::Share& share : shares[i])
        if (share.driven == driven) sum = combined(1, sum, share.ratio, by_position_of_chain(i));
    return sum;
  }

  Values by_position_of_chain(std::size_t joint) const {
    const Number half = Number(1) / Number(2);
    if (robot_.joints[joint].type == model::JointType::prismatic)
      return combined(half, moved({joint, {}, 1}), -half, moved({joint, {}, -1}));
    // A trigonometric polynomial of degree two: f'(x) = 25/12 o(t) - 2/3 o(pi/2), where
    // o(s) = (f(x + s) - f(x - s))/2 and sin t = 4/5.
    const Number sine = Number(4) / Number(5), cosine = Number(3) / Number(5);
    const Values small =
        combined(half, moved({joint, {cosine, sine}, 0}), -half, moved({joint, {cosine, -sine}, 0}));
    const Values right = combined(half, moved({joint, {0, 1}, 0}), -half, moved({joint, {0, -1}, 0}));
    return combined(Number(25) / Number(12), small, Number(-2) / Number(3), right);
  }

  Values moved(const PlainRecursion::Move& move) const {
    return PlainRecursion(robot_, point_, move)
        .inverse_dynamics(plain_.rates(), plain_.accelerations(), load_);
  }

  const model::Robot& robot_;
  const ExactPoint& point_;
  PlainRecursion plain_;
  PlainRecursion::Load load_;
};

Values expected(const model::Robot& robot, const ExactPoint& point) {
  const Differences differences(robot, point);
  Values result = differences.torques();
  for (std::size_t k = 0; k < model::coordinate_count(robot); ++k)
    for (const Values& column : {differences.by_position(k), differences.by_rate(k)})
      result.insert(result.end(), column.begin(), column.end());
  return result;
}

/// Searched without values that the forms do not have: they share enough as they are, and new values would
/// only slow the closure down.
Optimised searched(const Quantity& quantity, const DynamicsEffort& effort) {
  OptimiseOptions options = final_search(effort);
  options.search.limit = 0;
  options.more_steps = 0;
  return optimise(quantity, options);
}

/// Y b - tau, the columns of Y one after the other in `values`.
Values regressor_residuals(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
                           bool with_drives, const ExactPoint& point, const Values& values) {
  PlainRecursion plain(robot, point);
  plain.take_standard_parameters();
  if (with_drives) plain.take_drive_parameters();
  Values rest = plain.inverse_dynamics(plain.rates(), plain.accelerations(), plain.usual_load());
  const Values parameters = dag::evaluate<Number>(regressor.base_parameters, point);
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = rest[i] - values[k * rest.size() + i] * parameters[k];
  return rest;
}

using Columns = std::vector<std::vector<dag::Edge>>;

/// The outputs behind the first `rows` as columns.
Columns columns_of(const dag::Function& form, std::size_t rows) {
  Columns columns;
  for (std::size_t i = rows; i < form.outputs.size(); ++i) {
    if (i % rows == 0) columns.emplace_back();
    columns.back().push_back(form.outputs[i].value);
  }
  return columns;
}

/// The derivative by a motor's position: a joint that is the motor itself counts once, the others by their
/// ratios.
std::vector<dag::Edge> by_motor(const model::Robot& robot, const std::string& motor, std::size_t driven,
                                const Columns& by_joint, dag::Graph& graph) {
  std::vector<dag::Edge> sum(by_joint.front().size(), graph.constant(0));
  const auto shares = model::shares(robot);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (robot.joints[i].variable == motor) sum = by_joint[2 * i];
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (const model::Share& share : shares[i])
      for (std::size_t row = 0; row < sum.size() && share.driven == driven; ++row) {
        if (robot.joints[i].variable == motor) continue;
        const dag::Edge ratio = graph.constant(exact::Number(share.ratio));
        sum[row] = graph.sum({sum[row], graph.product({ratio, by_joint[2 * i][row]})});
      }
  return sum;
}

/// Columns of the chain's joints, by position and by rate in turn, then the motors' by position and by rate,
/// as columns of the motors. Rates of followers do not occur, positions of motors neither.
void gather_derivatives(const model::Robot& robot, std::size_t rows, dag::Function& form) {
  const Columns columns = columns_of(form, rows);
  const std::vector<std::string> variables = model::variables(robot);
  form.outputs.resize(rows);
  for (std::size_t driven = 0; driven < variables.size(); ++driven) {
    const auto is_it = [&](const auto& each) { return each.variable == variables[driven]; };
    const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(), is_it);
    const auto motor = std::find_if(robot.motors.begin(), robot.motors.end(), is_it);
    const auto place = motor == robot.motors.end() ? joint - robot.joints.begin()
                                                   : static_cast<std::ptrdiff_t>(robot.joints.size()) +
                                                         (motor - robot.motors.begin());
    const std::vector<dag::Edge> by_position =
        by_motor(robot, variables[driven], driven, columns, form.graph);
    const std::vector<dag::Edge>& by_rate = columns[static_cast<std::size_t>(2 * place + 1)];
    for (const auto& [letter, column] : {std::pair("q", &by_position), std::pair("v", &by_rate)})
      for (std::size_t row = 0; row < rows; ++row)
        form.outputs.push_back(
            {letter + std::to_string(row + 1) + "_" + std::to_string(model::base_motions(robot) + driven + 1),
             (*column)[row]});
  }
}

/// Derivatives of a function's outputs by one of its symbols, with the arithmetic to combine them.
class OutputRates {
 public:
  explicit OutputRates(dag::Function& form) : form_(form), outputs_(form.outputs), size_(form.graph.size()) {}

  std::vector<dag::Edge> by(const std::string& symbol) const {
    const std::vector<dag::Edge> rates = passes::derivatives(form_.graph, size_, symbol);
    std::vector<dag::Edge> column;
    for (const dag::Output& output : outputs_) {
      const dag::Edge rate = rates[output.value.node];
      column.push_back(output.value.negative ? -rate : rate);
    }
    return column;
  }
  /// a x - b y for symbols a and b.
  std::vector<dag::Edge> combined(const std::string& a, const std::vector<dag::Edge>& x, const std::string& b,
                                  const std::vector<dag::Edge>& y) const {
    dag::Graph& graph = form_.graph;
    std::vector<dag::Edge> result;
    for (std::size_t i = 0; i < x.size(); ++i)
      result.push_back(
          graph.sum({graph.product({graph.symbol(a), x[i]}), -graph.product({graph.symbol(b), y[i]})}));
    return result;
  }
  std::vector<dag::Edge> zero() const { return {outputs_.size(), form_.graph.constant(0)}; }

 private:
  dag::Function& form_;
  std::vector<dag::Output> outputs_;
  std::uint32_t size_;
};

/// By the motions of a floating base, by position and by rate in turn. Where the base is makes no difference;
/// a turn of it about an axis e changes the gravity g that it sees by g x e.
std::vector<dag::Output> columns_of_base(const model::Robot& robot, const OutputRates& columns) {
  std::vector<std::vector<dag::Edge>> by_gravity;
  for (std::size_t k = 0; k < 3 && robot.floating_base; ++k)
    by_gravity.push_back(columns.by(derive::dynamics::gravity_component(k)));
  std::vector<dag::Output> result;
  const auto add = [&](const std::string& prefix, std::size_t number, const std::vector<dag::Edge>& column) {
    for (std::size_t row = 0; row < column.size(); ++row)
      result.push_back({prefix + std::to_string(row + 1) + "_" + std::to_string(number), column[row]});
  };
  for (std::size_t motion = 0; motion < model::base_motions(robot); ++motion) {
    const std::size_t i = (motion + 1) % 3, j = (motion + 2) % 3;
    add("q", motion + 1,
        motion < 3 ? columns.zero()
                   : columns.combined(derive::dynamics::gravity_component(j), by_gravity[i],
                                      derive::dynamics::gravity_component(i), by_gravity[j]));
    add("v", motion + 1, columns.by(derive::dynamics::velocity_of(model::base_coordinate(motion))));
  }
  return result;
}

/// Appends the derivatives by the base's motions and by the motors: the change of a follower's value belongs
/// to its leaders.
void append_derivatives(const model::Robot& robot, dag::Function& form) {
  const std::size_t rows = form.outputs.size();
  const OutputRates columns(form);
  std::vector<passes::Direction> directions;
  const auto add = [&](const std::string& variable) {
    const std::size_t number = model::base_motions(robot) + directions.size() / 2 + 1;
    directions.push_back({variable, "q", number});
    directions.push_back({derive::dynamics::velocity_of(variable), "v", number});
  };
  for (const model::Joint& joint : robot.joints) add(joint.variable);
  for (const model::Motor& motor : robot.motors) add(motor.variable);
  passes::append_derivatives(form, directions);
  if (model::has_followers(robot)) gather_derivatives(robot, rows, form);
  const std::vector<dag::Output> of_base = columns_of_base(robot, columns);
  form.outputs.insert(form.outputs.begin() + static_cast<std::ptrdiff_t>(rows), of_base.begin(),
                      of_base.end());
}

/// The torques and their derivatives as the chain rule gives them. Ways to compute the torques that cost the
/// same differ by what their derivatives cost: the best of several is taken.
dag::Function cheapest_derivatives(const model::Robot& robot, const dag::Function& torques,
                                   const DynamicsEffort& effort) {
  passes::SearchOptions options;
  options.iterations = effort.trial_steps;
  options.restarts = 1;
  options.is_free_symbol = free_symbols(robot);
  dag::Function best;
  int fewest = 0;
  for (std::uint64_t seed = 0; seed <= more_ways; ++seed) {
    options.seed = seed;
    dag::Function form = seed == 0 ? torques : passes::search({torques}, {}, options);
    append_derivatives(robot, form);
    const dag::OperationCounts counts = dag::count(form, options.is_free_symbol);
    const int found = counts.multiplications + counts.additions;
    if (seed > 0 && found >= fewest) continue;
    best = std::move(form);
    fewest = found;
  }
  return best;
}

}  // namespace

Optimised regressor_function(const DynamicsModel& model, const derive::dynamics::Regressor& regressor,
                             const DynamicsEffort& effort) {
  const auto residuals = [&](const ExactPoint& point, const Values& values) {
    return regressor_residuals(model.described, regressor, false, point, values);
  };
  return searched(quantity_of(model, "regressor", regressor.formulation, residuals), effort);
}

Optimised drive_regressor_function(const DynamicsModel& model, const derive::dynamics::Regressor& regressor,
                                   const DynamicsEffort& effort) {
  const auto residuals = [&](const ExactPoint& point, const Values& values) {
    return regressor_residuals(model.described, regressor, true, point, values);
  };
  return searched(quantity_of(model, "regressor_with_drives", regressor.formulation, residuals), effort);
}

Optimised inverse_dynamics_derivatives(const DynamicsModel& model, const Optimised& inverse_dynamics,
                                       const DynamicsEffort& effort) {
  const model::Robot& robot = model.arm.robot;
  const derive::dynamics::Formulation by_composite_bodies = derive::dynamics::inverse_dynamics_derivatives(
      robot, inverse_dynamics.choices.value_or(derive::dynamics::FormulationOptions{}));
  const auto residuals = [&](const ExactPoint& point, const Values& values) {
    return combined(1, values, -1, expected(model.described, point));
  };
  Quantity quantity = quantity_of(model, "inverse_dynamics_derivatives", by_composite_bodies, residuals);
  if (model::coordinate_count(robot) <= most_coordinates_by_chain_rule)
    quantity.forms.push_back({"", cheapest_derivatives(robot, inverse_dynamics.of_arm.function, effort)});
  Optimised result = searched(quantity, effort);
  result.choices = inverse_dynamics.choices;
  return result;
}

}  // namespace qvgen::optimise
