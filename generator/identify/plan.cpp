// SPDX-License-Identifier: MIT
#include "identify/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "identify/prior.h"
#include "model/evaluate.h"
#include "model/motor_ranges.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index harmonics = 5;
/// Samples that a trial is judged by.
constexpr double trial_rate = 10;
/// Share of the time in which a motion begins, and ends.
constexpr double ramp = 0.1;
/// Half range of a turning joint without limits, rad.
constexpr double free_range = std::numbers::pi / 2;

struct Range {
  double middle, half, speed;
  bool has_limits = false;
};

/// Coefficients of sines, then of cosines: a row a joint.
using Series = MatrixXd;

double number(const model::Expression& expression, const model::Bindings& values) {
  return model::to_double(model::evaluate(expression, values));
}

Range range_of(const model::Joint& joint, const model::Bindings& values, const PlanRequest& request) {
  Range range{0, free_range, request.speed};
  if (joint.limits) {
    const double lower = number(joint.limits->lower, values), upper = number(joint.limits->upper, values);
    range = {(lower + upper) / 2, (upper - lower) / 2, request.speed, true};
  } else if (joint.type == model::JointType::prismatic) {
    throw std::runtime_error(joint.variable +
                             " slides and has no limits: write limits = [lower, upper], so that a "
                             "motion can be planned");
  }
  if (joint.greatest_velocity) range.speed = number(*joint.greatest_velocity, values);
  range.half *= request.share;
  range.speed *= request.share;
  return range;
}

double sum_of_middles(const model::SharedLimits& limits, const std::vector<Range>& ranges) {
  double sum = 0;
  for (const model::Share& share : limits.shares)
    sum += cln::double_approx(share.ratio) * ranges[share.driven].middle;
  return sum;
}

/// Moves the middles of some motors' ranges by the shortest way that takes their joint from the outer halves
/// of its range to the middle.
void take_to_middle(const model::SharedLimits& limits, std::vector<Range>& ranges) {
  const double middle = (limits.lower + limits.upper) / 2, off = middle - sum_of_middles(limits, ranges);
  if (std::abs(off) <= (limits.upper - limits.lower) / 4) return;
  double squares = 0;
  for (const model::Share& share : limits.shares) squares += std::pow(cln::double_approx(share.ratio), 2);
  for (const model::Share& share : limits.shares) {
    Range& range = ranges[share.driven];
    const double by = off / squares * cln::double_approx(share.ratio);
    range.middle += by;
    if (range.has_limits) range.half -= std::abs(by);
  }
}

/// Makes ranges so small that their joint stays inside wherever the motors are.
void narrow(const model::SharedLimits& limits, double part, std::vector<Range>& ranges) {
  const double at = sum_of_middles(limits, ranges),
               room = part * std::min(limits.upper - at, at - limits.lower);
  double need = 0;
  bool has_room = room > 0;
  for (const model::Share& share : limits.shares) {
    need += std::abs(cln::double_approx(share.ratio)) * ranges[share.driven].half;
    has_room = has_room && ranges[share.driven].half > 0;
  }
  if (!has_room)
    throw std::runtime_error(
        fmt::format("the limits of '{}' = {} and those of its motors leave no room about one "
                    "middle: correct them",
                    limits.joint, limits.sum));
  for (const model::Share& share : limits.shares) ranges[share.driven].half *= std::min(1.0, room / need);
}

std::vector<Range> ranges_of(const model::Robot& robot, const PlanRequest& request) {
  constexpr int sweeps = 20;
  const model::Bindings values = model::default_bindings(robot);
  std::vector<Range> ranges;
  for (const model::Joint& joint : model::driven_joints(robot))
    ranges.push_back(range_of(joint, values, request));
  const std::vector<model::SharedLimits> shared = model::shared_limits(robot);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const model::SharedLimits& limits : shared) take_to_middle(limits, ranges);
  for (const model::SharedLimits& limits : shared) narrow(limits, request.share, ranges);
  return ranges;
}

/// From 0 to 1 with two derivatives that vanish at both ends; and these derivatives.
struct Envelope {
  double value = 1, first = 0, second = 0;
};

Envelope envelope_at(double time, double seconds) {
  const double length = ramp * seconds;
  const bool begins = time<length, ends = time> seconds - length;
  if (!begins && !ends) return {};
  const double x = std::clamp((begins ? time : seconds - time) / length, 0.0, 1.0), sign = begins ? 1 : -1;
  return {x * x * x * (10 + x * (6 * x - 15)), sign * 30 * x * x * (1 - x) * (1 - x) / length,
          60 * x * (1 - x) * (1 - 2 * x) / (length * length)};
}

/// The motion of one joint about its middle.
void fill_joint(const Series& series, Index joint, double seconds, MotionLog& log) {
  for (Index k = 0; k < log.samples(); ++k) {
    const double t = log.time[static_cast<std::size_t>(k)];
    double value = 0, first = 0, second = 0;
    for (Index h = 0; h < harmonics; ++h) {
      const double w = 2 * std::numbers::pi * static_cast<double>(h + 1) / seconds;
      const double a = series(joint, h), b = series(joint, harmonics + h), s = std::sin(w * t),
                   c = std::cos(w * t);
      value += a * s + b * c;
      first += w * (a * c - b * s);
      second -= w * w * (a * s + b * c);
    }
    const Envelope e = envelope_at(t, seconds);
    log.q(k, joint) = e.value * value;
    log.qd(k, joint) = e.value * first + e.first * value;
    log.qdd(k, joint) = e.value * second + 2 * e.first * first + e.second * value;
  }
}

/// A joint's motion made as large as its range and its speed allow.
void fit(const Range& range, Index joint, MotionLog& log) {
  const double reach = log.q.col(joint).cwiseAbs().maxCoeff(),
               speed = log.qd.col(joint).cwiseAbs().maxCoeff();
  const double factor = std::min(range.half / std::max(reach, 1e-9), range.speed / std::max(speed, 1e-9));
  for (MatrixXd* part : {&log.q, &log.qd, &log.qdd}) part->col(joint) *= factor;
  log.q.col(joint).array() += range.middle;
}

MotionLog motion_of(const std::vector<Range>& ranges, const Series& series, double seconds, double rate) {
  const auto samples = static_cast<Index>(std::floor(seconds * rate)) + 1;
  const auto joints = static_cast<Index>(ranges.size());
  MotionLog log{"plan", {}, {}, {}, {}, MatrixXd::Zero(samples, joints)};
  for (Index k = 0; k < samples; ++k) log.time.push_back(static_cast<double>(k) / rate);
  for (MatrixXd* part : {&log.q, &log.qd, &log.qdd}) part->setZero(samples, joints);
  for (Index i = 0; i < joints; ++i) {
    fill_joint(series, i, seconds, log);
    fit(ranges[static_cast<std::size_t>(i)], i, log);
  }
  return log;
}

Estimate expected(const ArmRegressor& arm, const MotionLog& log) {
  return estimate(equations_of(arm, log), arm.parameters(), VectorXd::Ones(log.joints()));
}

/// Torques that the described arm needs, beside its limits.
class Load {
 public:
  Load(const model::Robot& robot, const ArmRegressor& arm) : arm_(arm) {
    const model::Bindings values = model::default_bindings(robot);
    const auto joints = model::driven_joints(robot);
    limits_ = VectorXd::Constant(static_cast<Index>(joints.size()), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (joints[i].greatest_effort)
        limits_[static_cast<Index>(i)] = number(*joints[i].greatest_effort, values);
    if (const auto described = described_parameters(robot)) parameters_ = arm.combination * *described;
  }

  [[nodiscard]] bool known() const { return parameters_.size() > 0 && (limits_.array() < HUGE_VAL).any(); }
  /// Returns the greatest share of a limit that a motion needs.
  [[nodiscard]] double share_of(const MotionLog& motion) const {
    const MatrixXd torque = predicted(arm_, motion, parameters_);
    return (torque.cwiseAbs().colwise().maxCoeff().transpose().array() / limits_.array()).maxCoeff();
  }

 private:
  const ArmRegressor& arm_;
  VectorXd limits_, parameters_;
};

/// A motion made smaller about the middle of all ranges.
void shrink(const std::vector<Range>& ranges, double factor, MotionLog& log) {
  for (MatrixXd* part : {&log.qd, &log.qdd}) *part *= factor;
  for (Index i = 0; i < log.joints(); ++i) {
    const double middle = ranges[static_cast<std::size_t>(i)].middle;
    log.q.col(i) = middle + factor * (log.q.col(i).array() - middle);
  }
}

/// Makes a motion so small that its torques stay within a share of the limits; returns whether that is
/// possible.
bool make_bearable(const Load& load, const std::vector<Range>& ranges, double share, MotionLog& log) {
  constexpr int most_steps = 20;
  constexpr double step = 0.85;
  if (!load.known()) return true;
  for (int i = 0; i < most_steps; ++i) {
    if (load.share_of(log) <= share) return true;
    shrink(ranges, step, log);
  }
  return false;
}

/// Logarithm of the determinant of the information; each parameter that is not told counts as a catastrophe.
double information_of(const Estimate& estimate) {
  double sum = 0;
  for (Index k = 0; k < estimate.information.rows(); ++k)
    sum += std::log(std::max(std::abs(estimate.information(k, k)), 1e-12));
  return sum;
}

class Search {
 public:
  Search(const ArmRegressor& arm, const std::vector<Range>& ranges, const Load& load,
         const PlanRequest& request)
      : arm_(arm), ranges_(ranges), load_(load), request_(request) {}

  Series best(int trials) {
    const auto joints = static_cast<Index>(ranges_.size());
    for (int trial = 0; trial < trials; ++trial) {
      const Series noise = Series::NullaryExpr(joints, 2 * harmonics, [&] { return normal_(random_); });
      // A third of the trials begin anew, the others change the best by less and less.
      const double change = std::exp(-4.0 * trial / trials);
      consider(3 * trial < trials ? noise : Series(best_ + change * noise));
    }
    return best_;
  }

 private:
  void consider(const Series& series) {
    MotionLog motion = motion_of(ranges_, series, request_.seconds, trial_rate);
    make_bearable(load_, ranges_, request_.share, motion);
    const double found = information_of(expected(arm_, motion));
    if (best_.size() > 0 && !(found > most_)) return;
    best_ = series;
    most_ = found;
  }

  const ArmRegressor& arm_;
  const std::vector<Range>& ranges_;
  const Load& load_;
  const PlanRequest& request_;
  double most_ = 0;
  Series best_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
};

}  // namespace

Plan plan(const model::Robot& robot, const PlanRequest& request) {
  const std::vector<Range> ranges = ranges_of(robot, request);
  ArmRegressor arm = arm_regressor(robot, request.drives);
  const Load load(robot, arm);
  const Series series = Search(arm, ranges, load, request).best(request.trials);
  MotionLog motion = motion_of(ranges, series, request.seconds, request.rate);
  if (!make_bearable(load, ranges, request.share, motion))
    throw std::runtime_error(
        fmt::format("in the middle of its ranges alone the arm needs more than {:.0f} % of an effort limit: "
                    "correct the limits, or the inertias, or the ranges",
                    100 * request.share));
  std::optional<double> effort;
  if (load.known()) effort = load.share_of(motion);
  const Estimate estimate = expected(arm, motion);
  return {std::move(motion), estimate.condition, std::move(arm), estimate.deviation, effort};
}

std::string plan_summary(const Plan& plan) {
  std::string text =
      fmt::format("{} samples; condition number {:.3g}; deviations for white noise of 1 Nm (N):\n",
                  plan.motion.samples(), plan.condition);
  for (Index k = 0; k < plan.deviation.size(); ++k)
    text += fmt::format("{:<16}{:>12.2g}\n", plan.arm.names[static_cast<std::size_t>(k)], plan.deviation[k]);
  text += plan.effort ? fmt::format("torques of the described arm: at most {:.0f} % of its effort limits\n",
                                    100 * *plan.effort)
                      : "torques were not looked at: the description lacks inertias, or effort limits\n";
  return text;
}

std::string plan_table(const model::Robot& robot, const MotionLog& motion) {
  std::string text = "time [s]";
  std::vector<std::string> units;
  for (const model::Joint& joint : model::driven_joints(robot))
    units.push_back(joint.type == model::JointType::revolute ? "rad" : "m");
  for (const auto& [name, per] : {std::pair("q", ""), std::pair("qd", "/s")})
    for (std::size_t i = 0; i < units.size(); ++i)
      text += fmt::format(", {}{} [{}{}]", name, i + 1, units[i], per);
  text += "\n";
  for (Index k = 0; k < motion.samples(); ++k) {
    text += fmt::format("{:.6g}", motion.time[static_cast<std::size_t>(k)]);
    for (const MatrixXd* part : {&motion.q, &motion.qd})
      for (Index i = 0; i < motion.joints(); ++i) text += fmt::format(", {:.9g}", (*part)(k, i));
    text += "\n";
  }
  return text;
}

}  // namespace qvgen::identify
