// SPDX-License-Identifier: MIT
#include "identify/identification.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/derivatives.h"
#include "identify/extra_columns.h"
#include "identify/prior.h"
#include "identify/suspicion.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Samples of each log that rates of Stribeck are tried on, and that windows have at their most.
constexpr Index trial_samples = 10'000;
/// Windows are tried at so many samples of each log, or up to twice as many.
constexpr Index window_samples = 6'000;
constexpr double standstill_share = 0.01;

MotionLog beginning(const MotionLog& log, Index samples) {
  MotionLog result = log;
  if (samples >= log.samples()) return result;
  result.time.resize(std::min(log.time.size(), static_cast<std::size_t>(samples)));
  for (Eigen::MatrixXd* part : {&result.q, &result.qd, &result.qdd, &result.torque, &result.temperature})
    if (part->rows() > 0) part->conservativeResize(samples, Eigen::NoChange);
  return result;
}

Equations equations_of_all(const ArmRegressor& arm, const std::vector<MotionLog>& logs, const UseOfLog& use) {
  Equations all = equations_of(arm, logs.front(), use);
  for (std::size_t i = 1; i < logs.size(); ++i) add(all, equations_of(arm, logs[i], use));
  return all;
}

bool has_coulomb(const ArmRegressor& arm) {
  return std::find(arm.drives.begin(), arm.drives.end(), DriveParameter::coulomb_friction) !=
         arm.drives.end();
}

/// Greatest finite rate of each joint.
VectorXd greatest_rates(const std::vector<MotionLog>& logs) {
  VectorXd greatest = VectorXd::Zero(logs.front().joints());
  for (const MotionLog& log : logs)
    for (Index i = 0; i < log.joints(); ++i)
      for (Index k = 0; k < log.samples(); ++k)
        if (std::isfinite(log.qd(k, i))) greatest[i] = std::max(greatest[i], std::abs(log.qd(k, i)));
  return greatest;
}

/// Returns the mean temperature of all logs.
double mean_temperature(const std::vector<MotionLog>& logs) {
  double sum = 0, count = 0;
  for (const MotionLog& log : logs)
    for (const double each : log.temperature.reshaped())
      if (std::isfinite(each)) sum += each, count += 1;
  return sum / std::max(1.0, count);
}

UseOfLog use_of(const ArmRegressor& arm, const std::vector<MotionLog>& logs, const Request& request) {
  if (!has_coulomb(arm)) return {};
  UseOfLog use;
  const VectorXd greatest = greatest_rates(logs);
  for (Index i = 0; i < greatest.size(); ++i)
    use.slowest.push_back(request.standstill.value_or(standstill_share * greatest[i]));
  return use;
}

bool derives(const MotionLog& log) { return log.qd.rows() == 0 || log.qdd.rows() == 0; }

void derive_all(std::vector<MotionLog>& logs, Index half) {
  for (MotionLog& log : logs) derive_motion(log, half);
}

/// Returns some of a log's samples, evenly spaced, with rates and accelerations from all.
MotionLog derived_sample(MotionLog log, Index half) {
  const Index stride = std::max<Index>(1, log.samples() / window_samples);
  derive_motion(log, half, stride);
  if (stride == 1) return log;
  const auto kept = Eigen::seq(0, log.samples() - 1, stride);
  for (MatrixXd* part : {&log.q, &log.qd, &log.qdd, &log.torque, &log.temperature})
    if (part->rows() > 0) *part = MatrixXd((*part)(kept, Eigen::all));
  std::vector<double> time;
  for (std::size_t k = 0; k < log.time.size(); k += static_cast<std::size_t>(stride))
    time.push_back(log.time[k]);
  log.time = std::move(time);
  return log;
}

/// Sum of the logarithms of the joints' noise: the less, the more likely are the data.
double unlikelihood(const ArmRegressor& arm, const std::vector<MotionLog>& all, Index half,
                    const Request& request) {
  std::vector<MotionLog> logs;
  for (const MotionLog& log : all) logs.push_back(derived_sample(log, half));
  const Estimate found = estimate(equations_of_all(arm, logs, use_of(arm, logs, request)), arm.parameters());
  return found.noise.array().max(std::numeric_limits<double>::min()).log().sum();
}

/// The window that lets the torques be predicted best.
Index best_half(const ArmRegressor& arm, const std::vector<MotionLog>& logs, const Request& request) {
  Index shortest = trial_samples;
  for (const MotionLog& log : logs) shortest = std::min(shortest, log.samples());
  Index best = 0;
  double least = 0;
  for (const Index half : windows_for(shortest)) {
    const double found = unlikelihood(arm, logs, half, request);
    if (best != 0 && found >= least) continue;
    best = half;
    least = found;
  }
  return best;
}

/// Fills in rates and accelerations of all logs; a window that is not given is chosen by those that are
/// fitted.
Filter filtered(const ArmRegressor& arm, std::vector<MotionLog>& logs, std::vector<MotionLog>& hold_out,
                std::vector<MotionLog>& payload, const Request& request) {
  Filter filter;
  for (const MotionLog& log : logs) {
    filter.rates |= log.qd.rows() == 0;
    filter.accelerations |= log.qdd.rows() == 0;
  }
  bool any = false;
  for (const auto* part : {&logs, &hold_out, &payload})
    any |= std::any_of(part->begin(), part->end(), derives);
  if (!any) return filter;
  filter.half = request.window ? (*request.window - 1) / 2 : best_half(arm, logs, request);
  const auto timed = std::find_if(logs.begin(), logs.end(), derives);
  if (timed != logs.end()) filter.band = band_of(filter.half, usual_step(timed->time));
  for (auto* part : {&logs, &hold_out, &payload}) derive_all(*part, filter.half);
  return filter;
}

/// Chooses each joint's rate of Stribeck: of some shares of its greatest rate the one that leaves least.
void choose_stribeck_rates(ArmRegressor& arm, const std::vector<MotionLog>& logs, const UseOfLog& use) {
  std::vector<MotionLog> trial;
  for (const MotionLog& log : logs) trial.push_back(beginning(log, trial_samples));
  const VectorXd greatest = greatest_rates(trial);
  VectorXd best = VectorXd::Constant(greatest.size(), 0), least = best;
  for (const double share : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    arm.stribeck_rate = (share * greatest).cwiseMax(std::numeric_limits<double>::min());
    const VectorXd noise = estimate(equations_of_all(arm, trial, use), arm.parameters()).noise;
    for (Index i = 0; i < noise.size(); ++i)
      if (best[i] == 0 || noise[i] < least[i]) best[i] = arm.stribeck_rate[i], least[i] = noise[i];
  }
  arm.stribeck_rate = best;
}

/// Correlation of each joint's residual with the one of the next sample.
VectorXd correlations(const ArmRegressor& arm, const std::vector<MotionLog>& logs,
                      const VectorXd& parameters) {
  const auto joints = static_cast<Index>(arm.joints);
  VectorXd products = VectorXd::Zero(joints), squares = VectorXd::Zero(joints);
  for (const MotionLog& log : logs) {
    const Eigen::MatrixXd residual = log.torque - predicted(arm, log, parameters);
    for (Index i = 0; i < joints; ++i)
      for (Index k = 0; k + 1 < residual.rows(); ++k) {
        const double product = residual(k, i) * residual(k + 1, i);
        if (!std::isfinite(product)) continue;
        products[i] += product;
        squares[i] += residual(k, i) * residual(k, i);
      }
  }
  return products.cwiseQuotient(squares.cwiseMax(std::numeric_limits<double>::min()));
}

std::vector<JointResidual> joints_of(const ArmRegressor& arm, const Equations& equations,
                                     const Estimate& estimate, const std::vector<MotionLog>& logs) {
  const VectorXd levels = torque_levels(equations), rest = residuals(equations, estimate.value);
  const VectorXd lasting = correlations(arm, logs, estimate.value);
  std::vector<JointResidual> joints;
  for (Index i = 0; i < levels.size(); ++i)
    joints.push_back({estimate.measured[static_cast<std::size_t>(i)], levels[i], rest[i], estimate.noise[i],
                      lasting[i], std::nullopt});
  return joints;
}

/// True if a joint's residual is large, and lasts: a model that lacks something.
bool is_unexplained(const JointResidual& joint) {
  constexpr double share = 0.1, lasting_share = 0.6;
  return joint.residual > share * joint.torque && joint.correlation > lasting_share;
}

}  // namespace

Identification identify(const model::Robot& robot, std::vector<MotionLog> logs,
                        std::vector<MotionLog> hold_out, const Request& request,
                        std::vector<MotionLog> payload) {
  Identification result{arm_regressor(robot, request.drives, request.gravity), {}, {}, {}, {}, {}, {}};
  add_extra_columns(result.arm, request.stribeck, request.temperature);
  result.arm.temperature = mean_temperature(logs);
  result.filter = filtered(result.arm, logs, hold_out, payload, request);
  const UseOfLog use = use_of(result.arm, logs, request);
  result.standstill = use.slowest;
  if (request.stribeck) choose_stribeck_rates(result.arm, logs, use);
  const Equations equations = equations_of_all(result.arm, logs, use);
  result.estimate = estimate(equations, result.arm.parameters());
  ArmRegressor bodies = result.arm;
  bodies.combination = combination_without_extra(result.arm);
  const Estimate of_bodies = without_extra(result.arm, result.estimate);
  result.full = closest_consistent(bodies, of_bodies, prior_of(robot, bodies, of_bodies, request.mass));
  result.joints = joints_of(result.arm, equations, result.estimate, logs);
  result.doubts = oddities(result.arm, result.estimate);
  if (std::any_of(result.joints.begin(), result.joints.end(), is_unexplained))
    if (const std::string doubt = suspicion(result.arm, logs); !doubt.empty())
      result.doubts.insert(result.doubts.begin(), doubt);
  if (!hold_out.empty()) {
    const VectorXd rest = residuals(equations_of_all(result.arm, hold_out, use), result.estimate.value);
    for (Index i = 0; i < rest.size(); ++i) result.joints[static_cast<std::size_t>(i)].hold_out = rest[i];
  }
  if (!payload.empty())
    result.payload = payload_of(result.arm, equations, equations_of_all(result.arm, payload, use));
  result.logs = std::move(logs);
  return result;
}

}  // namespace qvgen::identify
