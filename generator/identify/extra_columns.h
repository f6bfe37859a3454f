// SPDX-License-Identifier: MIT
// Friction that no description has: columns of Y beside those of bodies and drives, each in one joint's own
// row.
//
//     stribeck    fs sign(q') exp(-(q'/v)^2)      at low rates friction is higher, or lower, than Coulomb's
//     warmth      (fvT q' + fcT sign(q')) (T - T0)   friction falls as the gear warms up
//
// The torque is linear in fs, fvT and fcT; v is chosen among some shares of the joint's greatest rate.
#pragma once

#include <string>

#include "identify/estimate.h"
#include "identify/motion_log.h"

namespace qvgen::identify {

/// Appends columns to an arm's: "fs1", ...; and "fvT1", "fcT1", ... of the temperature.
void add_extra_columns(ArmRegressor& arm, bool stribeck, bool temperature);

/// Fills in the values of a column, which is an extra one, for so many samples.
void fill_extra(const ArmRegressor& arm, const MotionLog& log, Eigen::Index column, Eigen::Index first,
                Eigen::Index count, double* to);

/// True if the joint's row of a sample lacks nothing that the extra columns need.
bool has_extra(const ArmRegressor& arm, const MotionLog& log, Eigen::Index sample, Eigen::Index joint);

/// Returns the estimate of the parameters of bodies and drives, whatever the extra ones are.
Estimate without_extra(const ArmRegressor& arm, const Estimate& estimate);

/// Returns the arm without its extra parameters' rows of the combination.
Eigen::MatrixXd combination_without_extra(const ArmRegressor& arm);

/// Returns a parameter in words: "joint 2: fs sign(rate) exp(-(rate / 0.05)^2)".
std::string extra_definition(const ArmRegressor& arm, Eigen::Index parameter);

}  // namespace qvgen::identify
