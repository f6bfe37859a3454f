// SPDX-License-Identifier: MIT
#include "identify/suspicion.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

struct Slip {
  std::string words;
  std::function<void(MotionLog&)> undo;
};

/// Some thousand samples in pieces from all over a log, rates and all.
MotionLog some_of(const MotionLog& log) {
  constexpr Index pieces = 10, length = 250;
  if (log.samples() <= pieces * length) return log;
  MotionLog result = log;
  result.time.clear();
  for (const auto& [from, to] : {std::pair{&log.q, &result.q},
                                 {&log.qd, &result.qd},
                                 {&log.qdd, &result.qdd},
                                 {&log.torque, &result.torque},
                                 {&log.temperature, &result.temperature}}) {
    if (from->rows() == 0) continue;
    to->resize(pieces * length, from->cols());
    for (Index k = 0; k < pieces; ++k)
      to->middleRows(k * length, length) =
          from->middleRows(k * (log.samples() - length) / (pieces - 1), length);
  }
  return result;
}

void swap_columns(MatrixXd& matrix, Index a, Index b) {
  const Eigen::VectorXd column = matrix.col(a);
  matrix.col(a) = matrix.col(b);
  matrix.col(b) = column;
}

void scale_time(MotionLog& log, double factor) {
  log.qd /= factor;
  log.qdd /= factor * factor;
}

std::vector<Slip> usual_slips(Index joints) {
  std::vector<Slip> all;
  for (Index i = 0; i < joints; ++i)
    for (Index j = i + 1; j < joints; ++j) {
      all.push_back({fmt::format("columns torque{} and torque{} seem to be swapped", i + 1, j + 1),
                     [i, j](MotionLog& log) { swap_columns(log.torque, i, j); }});
      all.push_back(
          {fmt::format("columns q{} and q{} seem to be swapped", i + 1, j + 1), [i, j](MotionLog& log) {
             for (MatrixXd* part : {&log.q, &log.qd, &log.qdd}) swap_columns(*part, i, j);
           }});
    }
  for (Index i = 0; i < joints; ++i) {
    all.push_back({fmt::format("torque{} seems to have the other sign", i + 1),
                   [i](MotionLog& log) { log.torque.col(i) *= -1; }});
    all.push_back({fmt::format("q{} seems to have the other sign", i + 1), [i](MotionLog& log) {
                     for (MatrixXd* part : {&log.q, &log.qd, &log.qdd}) part->col(i) *= -1;
                   }});
  }
  all.push_back(
      {"the times seem to be milliseconds: write time [ms]", [](MotionLog& log) { scale_time(log, 1e-3); }});
  all.push_back(
      {"the times seem to be seconds: write time [s]", [](MotionLog& log) { scale_time(log, 1e3); }});
  return all;
}

/// Sum of the logarithms of what the joints' torques leave, all weighted by their own size.
double rest_of(const ArmRegressor& arm, const std::vector<MotionLog>& logs) {
  Equations all = equations_of(arm, logs.front());
  for (std::size_t i = 1; i < logs.size(); ++i) add(all, equations_of(arm, logs[i]));
  const Estimate found = estimate(all, arm.parameters(), torque_levels(all).cwiseMax(1e-12));
  return residuals(all, found.value).array().max(1e-12).log().sum();
}

}  // namespace

std::string suspicion(const ArmRegressor& arm, const std::vector<MotionLog>& logs) {
  constexpr double far_better = 1.5;
  std::vector<MotionLog> trial;
  for (const MotionLog& log : logs) trial.push_back(some_of(log));
  double least = rest_of(arm, trial) - far_better;
  std::string found;
  for (const Slip& slip : usual_slips(logs.front().joints())) {
    std::vector<MotionLog> other = trial;
    for (MotionLog& log : other) slip.undo(log);
    const double rest = rest_of(arm, other);
    if (rest >= least) continue;
    least = rest;
    found = slip.words;
  }
  return found;
}

std::vector<std::string> oddities(const ArmRegressor& arm, const Estimate& estimate) {
  constexpr double sure = 5, hardly = 1000;
  std::vector<std::string> result;
  for (Index k = 0; k < estimate.value.size(); ++k) {
    const std::string& name = arm.names[static_cast<std::size_t>(k)];
    const bool friction = name.starts_with("fv") || name.starts_with("fc");
    if (!friction || k >= arm.plain() || estimate.value[k] > -sure * estimate.deviation[k]) continue;
    result.push_back(
        name +
        " is negative, friction that drives: its torque or its position has the other sign, or the "
        "motion tells too little");
  }
  if (estimate.condition > hardly)
    result.push_back(fmt::format(
        "the condition number of these data is {:.2g}: they hardly tell parameters apart; log more "
        "motion, of all joints at once (--plan)",
        estimate.condition));
  return result;
}

}  // namespace qvgen::identify
