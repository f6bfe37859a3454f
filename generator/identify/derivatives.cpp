// SPDX-License-Identifier: MIT
#include "identify/derivatives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include "identify/chunks.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index degree = 4;
constexpr double gap = 5;
/// Times that differ from even ones by less than this share of a step are even.
constexpr double even = 1e-6;

/// Weights of the samples of a window that give the value at its middle and the two derivatives there.
using Weights = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Returns the weights for times relative to the middle of the window. The polynomials are orthogonal over
/// these times, and each follows from the two before it (Forsythe 1957).
Weights weights_at(const VectorXd& times) {
  const double scale = times.cwiseAbs().maxCoeff();
  const Eigen::ArrayXd x = times.array() / scale;
  Eigen::ArrayXd now = Eigen::ArrayXd::Ones(x.size()), before = Eigen::ArrayXd::Zero(x.size());
  // Value and two derivatives of both in the middle, where x is 0.
  Eigen::Vector3d middle = Eigen::Vector3d::UnitX(), middle_before = Eigen::Vector3d::Zero();
  Weights weights = Weights::Zero(3, x.size());
  double squares_before = std::numeric_limits<double>::infinity();
  for (Index k = 0; k <= degree; ++k) {
    const double squares = now.square().sum();
    weights += middle / squares * now.matrix().transpose();
    const double shift = (x * now.square()).sum() / squares, share = squares / squares_before;
    before = (x - shift) * now - share * before;
    now.swap(before);
    const Eigen::Vector3d by_x(0, middle[0], 2 * middle[1]);
    middle_before = by_x - shift * middle - share * middle_before;
    middle.swap(middle_before);
    squares_before = squares;
  }
  weights.row(1) /= scale;
  weights.row(2) /= scale * scale;
  return weights;
}

VectorXd even_times(Index half, double step) {
  return VectorXd::LinSpaced(2 * half + 1, -static_cast<double>(half), static_cast<double>(half)) * step;
}

/// The weights for each sample of a log: computed once where times are even.
class Windows {
 public:
  Windows(const std::vector<double>& time, Index half)
      : time_(VectorXd::Map(time.data(), static_cast<Index>(time.size()))),
        half_(half),
        step_(usual_step(time)),
        even_(even_times(half, step_)),
        of_even_(weights_at(even_)) {}

  Weights at(Index sample) const {
    const VectorXd times = (time_.segment(sample - half_, 2 * half_ + 1).array() - time_[sample]).matrix();
    return (times - even_).cwiseAbs().maxCoeff() < even * step_ ? of_even_ : weights_at(times);
  }

 private:
  VectorXd time_;
  Index half_;
  double step_;
  VectorXd even_;
  Weights of_even_;
};

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A sample's value and derivatives of all joints from what was measured around it.
void derive_sample(const MatrixXd& measured, const Weights& weights, Index sample, MatrixXd* value,
                   MatrixXd& first, MatrixXd* second) {
  const Index half = weights.cols() / 2;
  const MatrixXd result = weights * measured.middleRows(sample - half, weights.cols());
  if (value != nullptr) value->row(sample) = result.row(0);
  first.row(sample) = result.row(1);
  if (second != nullptr) second->row(sample) = result.row(2);
}

}  // namespace

double usual_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < time.size(); ++k) steps.push_back(time[k] - time[k - 1]);
  if (steps.empty()) return 1;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<std::pair<Index, Index>> pieces_of(const std::vector<double>& time) {
  std::vector<std::pair<Index, Index>> pieces;
  const double longest = gap * usual_step(time);
  Index first = 0;
  for (std::size_t k = 1; k <= time.size(); ++k) {
    if (k < time.size() && time[k] - time[k - 1] <= longest) continue;
    pieces.emplace_back(first, static_cast<Index>(k));
    first = static_cast<Index>(k);
  }
  return pieces;
}

void derive_motion(MotionLog& log, Index half, Index stride) {
  const bool rates = log.qd.rows() == 0, accelerations = log.qdd.rows() == 0;
  if (!rates && !accelerations) return;
  const MatrixXd measured = rates ? log.q : log.qd;
  const MatrixXd empty = MatrixXd::Constant(log.samples(), log.joints(), nothing);
  if (rates) log.qd = empty;
  if (accelerations) log.qdd = empty;
  const Windows windows(log.time, half);
  const auto derive = [&](Index k) {
    if (rates)
      derive_sample(measured, windows.at(k), k, &log.q, log.qd, accelerations ? &log.qdd : nullptr);
    else
      derive_sample(measured, windows.at(k), k, nullptr, log.qdd, nullptr);
  };
  for (const auto& [first, end] : pieces_of(log.time)) {
    const Index from = first + half;
    in_chunks(end - half - from, [&](Index begin, Index last) {
      for (Index k = from + begin; k < from + last; ++k)
        if (k % stride == 0) derive(k);
      return 0;
    });
  }
}

double band_of(Index half, double step) {
  const Weights weights = weights_at(even_times(half, step));
  const auto share = [&](double frequency) {
    const double w = 2 * std::numbers::pi * frequency;
    double sum = 0;
    for (Index k = 0; k < weights.cols(); ++k)
      sum += weights(2, k) * std::cos(w * step * static_cast<double>(k - half));
    return -sum / (w * w);
  };
  constexpr int parts = 2000;
  for (int k = 1; k <= parts; ++k) {
    const double frequency = 0.5 / step * k / parts;
    if (share(frequency) < std::sqrt(0.5)) return frequency;
  }
  return 0.5 / step;
}

std::vector<Index> windows_for(Index samples) {
  std::vector<Index> halves;
  for (const Index half : {3, 4, 6, 8, 11, 16, 22, 32, 45, 64, 90, 128})
    if (20 * half < samples) halves.push_back(half);
  if (halves.empty()) halves.push_back(3);
  return halves;
}

}  // namespace qvgen::identify
