// SPDX-License-Identifier: MIT
#include "identify/log_checks.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "model/evaluate.h"
#include "model/motor_ranges.h"

namespace qvgen::identify {
namespace {

using description::Diagnostic;
using Eigen::Index;

/// Beyond its limits by this much (rad, m) a joint has been moved by hand; further, the unit is another.
constexpr double beyond_limits = 0.2;
/// Farther than that (rad, m) a joint without limits does not go in a log; a motor by its gear farther.
constexpr double most_turned = 60;
/// A torque that stays at its greatest value for so many rows, while the joint moves, is a motor at its
/// bound.
constexpr Index saturated_rows = 5;
/// Rates that differ from those of the positions by this share are others.
constexpr double other_rate = 0.5;

void say(LogResult& result, Index sample, Diagnostic::Severity severity, const std::string& message,
         const std::string& hint) {
  const int line = result.lines[static_cast<std::size_t>(sample)];
  result.diagnostics.push_back({result.log.name, line, 1, severity, message, hint});
}

void check_time(LogResult& result) {
  const std::vector<double>& time = result.log.time;
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k] > time[k - 1]) continue;
    const std::string how = time[k] == time[k - 1] ? "stands still" : "goes back";
    return say(result, static_cast<Index>(k), Diagnostic::error,
               fmt::format("time {}: {} s after {} s", how, time[k], time[k - 1]),
               "write rows in the order of time; give logs that were joined as files of their own");
  }
}

std::pair<double, double> bounds_of(const model::Joint& joint, double gear, const model::Bindings& values) {
  if (!joint.limits) return {-most_turned * gear, most_turned * gear};
  return {model::to_double(model::evaluate(joint.limits->lower, values)) - beyond_limits,
          model::to_double(model::evaluate(joint.limits->upper, values)) + beyond_limits};
}

void check_positions(const model::Robot& robot, LogResult& result) {
  const model::Bindings values = model::default_bindings(robot);
  const std::vector<model::Joint> joints = model::driven_joints(robot);
  const std::vector<double> gears = model::greatest_gears(robot);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto [lower, upper] = bounds_of(joints[i], gears[i], values);
    const auto q = result.log.q.col(static_cast<Index>(i));
    for (Index k = 0; k < q.size(); ++k) {
      if (q[k] >= lower && q[k] <= upper) continue;
      const bool turns = joints[i].type == model::JointType::revolute;
      say(result, k, Diagnostic::error,
          fmt::format("q{} is {:g} {}, {}", i + 1, q[k], turns ? "rad" : "m",
                      joints[i].limits ? "beyond the joint's limits" : "which is many turns"),
          turns ? fmt::format("if the numbers are degrees, write q{} [deg]; or are columns swapped?", i + 1)
                : fmt::format("if the numbers are millimetres, write q{} [mm]; or are columns swapped?",
                              i + 1));
      break;
    }
  }
}

/// Looks for joints that several motors move beyond limits of their own.
void check_shared_limits(const model::Robot& robot, LogResult& result) {
  for (const model::SharedLimits& limits : model::shared_limits(robot))
    for (Index k = 0; k < result.log.samples(); ++k) {
      const double value = limits.at(result.log.q.row(k));
      if (value >= limits.lower - beyond_limits && value <= limits.upper + beyond_limits) continue;
      say(result, k, Diagnostic::error,
          fmt::format("{} = {:g} (rad, m), beyond the limits of the joint '{}'", limits.sum, value,
                      limits.joint),
          "are columns of two motors swapped, or does one count the other way?");
      break;
    }
}

/// Slope of the positions about a sample.
double slope(const MotionLog& log, Index k, Index joint) {
  const auto time = [&](Index at) { return log.time[static_cast<std::size_t>(at)]; };
  return (log.q(k + 1, joint) - log.q(k - 1, joint)) / (time(k + 1) - time(k - 1));
}

void check_rates(LogResult& result) {
  const MotionLog& log = result.log;
  if (log.time.empty() || log.qd.rows() == 0) return;
  for (Index i = 0; i < log.joints(); ++i) {
    double differences = 0, rates = 0, worst = 0;
    Index where = 0;
    for (Index k = 1; k + 1 < log.samples(); ++k) {
      const double rate = slope(log, k, i), difference = std::abs(log.qd(k, i) - rate);
      differences += difference * difference;
      rates += std::max(rate * rate, log.qd(k, i) * log.qd(k, i));
      if (difference > worst) {
        worst = difference;
        where = k;
      }
    }
    if (differences <= other_rate * other_rate * rates) continue;
    say(result, where, Diagnostic::error,
        fmt::format("qd{} is not the rate of q{}: {:g} here, where the positions change by {:g} per second",
                    i + 1, i + 1, log.qd(where, i), slope(log, where, i)),
        "check the units of time and rates, and whether columns are swapped");
  }
}

bool moves(const MotionLog& log, Index joint, Index first, Index last) {
  const auto q = log.q.col(joint).segment(first, last - first);
  return q.maxCoeff() - q.minCoeff() > 1e-6;
}

/// Takes runs of rows at a joint's greatest torque out.
void take_saturated(LogResult& result) {
  MotionLog& log = result.log;
  for (Index i = 0; i < log.torque.cols(); ++i) {
    const double greatest = log.torque.col(i).cwiseAbs().maxCoeff();
    Index rows = 0, line = 0;
    for (Index k = 0; k < log.samples();) {
      Index end = k;
      while (end < log.samples() && std::abs(log.torque(end, i)) >= greatest && greatest > 0) ++end;
      if (end - k >= saturated_rows && moves(log, i, k, end)) {
        if (rows == 0) line = k;
        rows += end - k;
        log.torque.col(i).segment(k, end - k).setConstant(std::numeric_limits<double>::quiet_NaN());
      }
      k = std::max(end, k + 1);
    }
    if (rows > 0)
      say(result, line, Diagnostic::warning,
          fmt::format(
              "torque{} stays at its greatest value {:g} from here: {} rows of a motor at its bound are left "
              "out",
              i + 1, greatest, rows),
          "move more slowly, or with less load");
  }
}

}  // namespace

void check_log(const model::Robot& robot, LogResult& result) {
  check_time(result);
  check_positions(robot, result);
  if (result.good()) check_shared_limits(robot, result);
  if (result.good()) check_rates(result);
  take_saturated(result);
}

}  // namespace qvgen::identify
