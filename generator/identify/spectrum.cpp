// SPDX-License-Identifier: MIT
#include "identify/spectrum.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Length of a piece: a power of two, eight pieces or more where there are enough values.
Index length_for(Index values) {
  Index length = 16;
  while (length < 1024 && 8 * length < values) length *= 2;
  return length;
}

VectorXd hann(Index length) {
  return VectorXd::NullaryExpr(length, [&](Index k) {
    return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) /
                                static_cast<double>(length));
  });
}

}  // namespace

std::vector<std::pair<double, double>> spectrum(const VectorXd& values, double step) {
  const Index length = length_for(values.size());
  const VectorXd window = hann(length);
  VectorXd power = VectorXd::Zero(length / 2 + 1);
  Eigen::FFT<double> fourier;
  double pieces = 0;
  for (Index at = 0; at + length <= values.size(); at += length / 2) {
    const VectorXd piece = values.segment(at, length);
    if (!piece.allFinite()) continue;
    const VectorXd windowed = (piece.array() - piece.mean()) * window.array();
    Eigen::VectorXcd transformed(length);
    fourier.fwd(transformed, windowed);
    power += transformed.head(power.size()).cwiseAbs2();
    ++pieces;
  }
  std::vector<std::pair<double, double>> result;
  if (pieces == 0) return result;
  const double scale = 2 * step / (window.squaredNorm() * pieces);
  for (Index k = 1; k < power.size(); ++k)
    result.emplace_back(static_cast<double>(k) / (static_cast<double>(length) * step),
                        std::sqrt(scale * power[k]));
  return result;
}

double band_of_power(const std::vector<std::pair<double, double>>& spectrum) {
  double all = 0, below = 0;
  for (const auto& [frequency, density] : spectrum) all += density * density;
  for (const auto& [frequency, density] : spectrum)
    if ((below += density * density) >= 0.9 * all) return frequency;
  return 0;
}

}  // namespace qvgen::identify
