// SPDX-License-Identifier: MIT
// Frequencies that a residual has. Noise of an instrument has all alike; what a model lacks is slow, or at a
// resonance.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace qvgen::identify {

/// Returns pairs of a frequency (Hz) and the square root of the power density there (unit of the values by
/// the square root of Hz), by averaged pieces that overlap by half (Welch). `step`: seconds between values.
/// Pieces with a value that is not finite are left out; nothing comes back if none is left.
std::vector<std::pair<double, double>> spectrum(const Eigen::VectorXd& values, double step);

/// Returns the frequency (Hz) below which lie nine tenths of a spectrum's power; 0 for none.
double band_of_power(const std::vector<std::pair<double, double>>& spectrum);

}  // namespace qvgen::identify
