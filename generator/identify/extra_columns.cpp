// SPDX-License-Identifier: MIT
#include "identify/extra_columns.h"

#include <cmath>

#include <fmt/format.h>

#include "matrices/decompositions.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void append(ArmRegressor& arm, ExtraKind kind, const char* name) {
  for (std::size_t joint = 0; joint < arm.joints; ++joint) {
    arm.columns[joint].push_back(arm.parameters());
    arm.names.push_back(name + std::to_string(joint + 1));
    arm.extra.push_back({joint, kind});
  }
}

const ExtraColumn& extra_of(const ArmRegressor& arm, Index column) {
  return arm.extra.at(static_cast<std::size_t>(column - arm.plain()));
}

double sign(double value) { return static_cast<double>((value > 0) - (value < 0)); }

}  // namespace

void add_extra_columns(ArmRegressor& arm, bool stribeck, bool temperature) {
  if (stribeck) append(arm, ExtraKind::stribeck, "fs");
  if (temperature) append(arm, ExtraKind::viscous_by_temperature, "fvT");
  if (temperature) append(arm, ExtraKind::coulomb_by_temperature, "fcT");
  const Index before = arm.combination.rows();
  arm.combination.conservativeResize(arm.parameters(), Eigen::NoChange);
  arm.combination.bottomRows(arm.parameters() - before).setZero();
  arm.stribeck_rate = Eigen::VectorXd::Ones(static_cast<Index>(arm.joints));
}

void fill_extra(const ArmRegressor& arm, const MotionLog& log, Index column, Index first, Index count,
                double* to) {
  const ExtraColumn& extra = extra_of(arm, column);
  const auto joint = static_cast<Index>(extra.joint);
  for (Index k = 0; k < count; ++k) {
    const double rate = log.qd(first + k, joint), share = rate / arm.stribeck_rate[joint];
    if (extra.kind == ExtraKind::stribeck)
      to[k] = sign(rate) * std::exp(-share * share);
    else
      to[k] = (extra.kind == ExtraKind::viscous_by_temperature ? rate : sign(rate)) *
              (log.temperature(first + k, joint) - arm.temperature);
  }
}

bool has_extra(const ArmRegressor& arm, const MotionLog& log, Index sample, Index joint) {
  const bool warm = !arm.extra.empty() && arm.extra.back().kind != ExtraKind::stribeck;
  return !warm || std::isfinite(log.temperature(sample, joint));
}

MatrixXd combination_without_extra(const ArmRegressor& arm) { return arm.combination.topRows(arm.plain()); }

Estimate without_extra(const ArmRegressor& arm, const Estimate& estimate) {
  if (arm.extra.empty()) return estimate;
  const Index kept = arm.plain(), others = estimate.value.size() - kept;
  // Extra columns first: below their rows of the triangle stands what the data say of the others alone.
  MatrixXd rows(estimate.information.rows(), estimate.value.size() + 1);
  rows << estimate.information.rightCols(others), estimate.information.leftCols(kept), estimate.right_side;
  const MatrixXd triangle = matrices::upper_triangle(rows);
  const Index below = std::max<Index>(0, std::min(triangle.rows(), others + kept) - others);
  Estimate result = estimate;
  result.information = triangle.block(others, others, below, kept);
  result.right_side = triangle.col(others + kept).segment(others, below);
  result.value = estimate.value.head(kept).eval();
  result.deviation = estimate.deviation.head(kept).eval();
  result.covariance = estimate.covariance.topLeftCorner(kept, kept).eval();
  result.parts = estimate.parts.topLeftCorner(kept, kept).eval();
  result.told.resize(static_cast<std::size_t>(kept));
  return result;
}

std::string extra_definition(const ArmRegressor& arm, Index parameter) {
  const ExtraColumn& extra = extra_of(arm, parameter);
  const std::string joint = fmt::format("joint {}: times ", extra.joint + 1);
  switch (extra.kind) {
    case ExtraKind::stribeck:
      return joint + fmt::format("sign(rate) exp(-(rate / {:.4g})^2)",
                                 arm.stribeck_rate[static_cast<Index>(extra.joint)]);
    case ExtraKind::viscous_by_temperature:
      return joint + fmt::format("rate (temperature - {:.4g} degC)", arm.temperature);
    case ExtraKind::coulomb_by_temperature:
      break;
  }
  return joint + fmt::format("sign(rate) (temperature - {:.4g} degC)", arm.temperature);
}

}  // namespace qvgen::identify
