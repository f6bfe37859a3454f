// SPDX-License-Identifier: MIT
// Rates and accelerations of measured positions: at each sample the polynomial of degree four that is nearest
// to the samples around it (Savitzky and Golay 1964), at the times at which they were taken. It has no phase,
// and follows motions up to a band that the number of samples decides. Across a gap in time nothing is
// fitted.
#pragma once

#include <vector>

#include "identify/motion_log.h"

namespace qvgen::identify {

/// Pieces of a log without gaps: first sample and end. A gap is longer than five usual steps of time.
std::vector<std::pair<Eigen::Index, Eigen::Index>> pieces_of(const std::vector<double>& time);

/// Returns the middle step of time, s.
double usual_step(const std::vector<double>& time);

/// Fills in rates and accelerations where they are missing, from windows of 2 half + 1 samples; with rates
/// that were measured, accelerations come from these. Positions become those of the polynomials where rates
/// are derived. Samples nearer than `half` to an end of a piece become nan: their windows would lean to one
/// side. With a stride only every so many samples get theirs, and all others become nan.
void derive_motion(MotionLog& log, Eigen::Index half, Eigen::Index stride = 1);

/// Returns the frequency (Hz) at which the second derivative has lost half of its power.
double band_of(Eigen::Index half, double step);

/// Windows that may be tried, by their half, for a log of that many samples.
std::vector<Eigen::Index> windows_for(Eigen::Index samples);

}  // namespace qvgen::identify
