// SPDX-License-Identifier: MIT
#include "calibrate/fit.h"

#include <algorithm>
#include <numeric>

#include "matrices/decompositions.h"

namespace qvgen::calibrate {
namespace {

double cost_of(const Model<double>& model, const Weighted& data, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < data.set->rows.size(); ++i) {
    if (data.weights[i] == 0) continue;
    const Measurement& row = data.set->rows[i];
    const Residual residual = residual_of(model, data.set->data, state, row, false);
    sum += data.weights[i] * residual.value.cwiseQuotient(deviations(data.set->data, row)).squaredNorm();
  }
  return sum;
}

/// Returns the squared size that a residual of so many entries exceeds once in a million times (Wilson and
/// Hilferty).
double rare_square(double entries) {
  const double share = 2 / (9 * entries);
  return std::pow(1 - share + 4.75 * std::sqrt(share), 3);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double entries_of(Data data) {
  return data == Data::pose || data == Data::camera ? 6 : data == Data::position ? 3 : 1;
}

/// Returns the scale of the sizes: their median, divided by that of so many normal numbers.
double scale_of(const std::vector<double>& sizes, Data data) {
  constexpr double rounding = 1e-7;
  const double share = 2 / (9 * entries_of(data));
  return std::max(rounding, median(sizes) / std::sqrt(std::pow(1 - share, 3)));
}

}  // namespace

Normal normal_of(const Model<double>& model, const Weighted& data, const State& state,
                 const std::vector<std::size_t>& active) {
  const auto count = static_cast<Eigen::Index>(active.size());
  Normal normal{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  Eigen::MatrixXd rows;
  for (std::size_t i = 0; i < data.set->rows.size(); ++i) {
    if (data.weights[i] == 0) continue;
    const Measurement& row = data.set->rows[i];
    const Residual residual = residual_of(model, data.set->data, state, row);
    const Eigen::VectorXd scale = std::sqrt(data.weights[i]) * deviations(data.set->data, row).cwiseInverse();
    rows.resize(residual.derivative.rows(), count);
    for (Eigen::Index k = 0; k < count; ++k)
      rows.col(k) = residual.derivative.col(static_cast<Eigen::Index>(active[static_cast<std::size_t>(k)]))
                        .cwiseProduct(scale);
    const Eigen::VectorXd value = residual.value.cwiseProduct(scale);
    normal.matrix.noalias() += rows.transpose() * rows;
    normal.gradient.noalias() += rows.transpose() * value;
    normal.cost += value.squaredNorm();
    normal.numbers += static_cast<double>(value.size());
  }
  return normal;
}

State fit(const Model<double>& model, const Weighted& data, State state,
          const std::vector<std::size_t>& active, int most) {
  double damping = 1e-6;
  for (int step = 0; step < most; ++step) {
    const Normal normal = normal_of(model, data, state, active);
    const Eigen::VectorXd diagonal = normal.matrix.diagonal().cwiseMax(1e-300);
    bool better = false;
    for (int trial = 0; trial < 12 && !better; ++trial) {
      Eigen::MatrixXd damped = normal.matrix;
      damped.diagonal() += damping * diagonal;
      const Eigen::VectorXd by = -matrices::solve_symmetric(damped, normal.gradient);
      const double promised = -by.dot(normal.gradient);
      if (!by.allFinite()) return state;
      if (promised <=
          1e-13 * (normal.cost + 1e-9)) {  // nothing to gain: the last step is made and checked all the same
        State last = moved(model, state, by, active);
        return cost_of(model, data, last) <= normal.cost ? last : state;
      }
      State next = moved(model, state, by, active);
      better = cost_of(model, data, next) < normal.cost;
      damping = better ? std::max(1e-12, damping / 10) : damping * 10;
      if (better) state = std::move(next);
    }
    if (!better) return state;
  }
  return state;
}

std::vector<double> sizes_of(const Model<double>& model, const DataSet& set, const State& state) {
  std::vector<double> sizes;
  for (const Measurement& row : set.rows) {
    const Eigen::VectorXd value =
        residual_of(model, set.data, state, row, false).value.cwiseQuotient(deviations(set.data, row));
    sizes.push_back(std::sqrt(value.squaredNorm() / static_cast<double>(value.size())));
  }
  return sizes;
}

RobustFit robust_fit(const Model<double>& model, const DataSet& set, const State& start,
                     const std::vector<std::size_t>& active, std::vector<double> weights) {
  const std::vector<double> wanted = weights;
  const auto leave_out = [&](const State& state, const auto& weight_of) {
    const std::vector<double> sizes = sizes_of(model, set, state);
    std::vector<double> used;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (wanted[i] > 0) used.push_back(sizes[i]);
    const double scale = scale_of(used, set.data);
    for (std::size_t i = 0; i < sizes.size(); ++i) weights[i] = wanted[i] * weight_of(sizes[i] / scale);
  };
  State state = fit(model, {&set, weights}, start, active);
  const double rare = std::sqrt(rare_square(entries_of(set.data)));
  const auto falling = [](double size) {
    return 1 / ((1 + size * size / 4) * (1 + size * size / 4));
  };  // Geman, McClure
  const std::vector<double> sizes = sizes_of(model, set, state);
  // Without any residual that stands out nothing is weighed down: the plain fit is the most exact one.
  bool stands_out = false;
  leave_out(state, [&](double size) {
    stands_out = stands_out || size > rare;
    return 1;
  });
  for (int round = 0; stands_out && round < 8; ++round) {
    leave_out(state, falling);
    state = fit(model, {&set, weights}, state, active, 10);
  }
  for (int round = 0; stands_out && round < 6; ++round) {
    const std::vector<double> before = weights;
    leave_out(state, [&](double size) { return size > rare ? 0 : 1; });
    state = fit(model, {&set, weights}, state, active);
    if (weights == before) break;
  }
  return {state, weights};
}

Size size_of(const Model<double>& model, const Weighted& data, const State& state) {
  Size size;
  double positions = 0, angles = 0;
  for (std::size_t i = 0; i < data.set->rows.size(); ++i) {
    if (data.weights[i] == 0) continue;
    const Eigen::VectorXd value = residual_of(model, data.set->data, state, data.set->rows[i], false).value;
    const Eigen::Index heads = std::min<Eigen::Index>(3, value.size());
    size.position += value.head(heads).squaredNorm();
    size.greatest_position = std::max(size.greatest_position, value.head(heads).norm());
    size.angle += value.tail(value.size() - heads).squaredNorm();
    positions += 1;
    angles += 1;
  }
  size.position = std::sqrt(size.position / std::max(1.0, positions));
  size.angle = std::sqrt(size.angle / std::max(1.0, angles));
  return size;
}

Rank numeric_rank(const Model<double>& model, const Weighted& data, const State& state,
                  const std::vector<std::size_t>& candidates) {
  const Normal normal = normal_of(model, data, state, candidates);
  const Eigen::VectorXd norms = normal.matrix.diagonal().cwiseSqrt().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled =
      norms.cwiseInverse().asDiagonal() * normal.matrix * norms.cwiseInverse().asDiagonal();
  std::vector<Eigen::Index> kept;
  Rank rank;
  for (Eigen::Index k = 0; k < scaled.cols(); ++k) {
    const std::size_t index = candidates[static_cast<std::size_t>(k)];
    const Parameter& each = model.parameters[index];
    const Eigen::VectorXd beside = scaled(kept, std::vector<Eigen::Index>{k});
    const Eigen::VectorXd share =
        kept.empty() ? Eigen::VectorXd() : matrices::solve_symmetric(scaled(kept, kept), beside);
    const double rest = 1 - (kept.empty() ? 0 : share.dot(beside));
    const double most = each.turn ? most_angle : most_length;
    const double needed = each.nuisance ? 0 : 1 / (most * norms[k]);
    constexpr double rounding = 1e-11;
    if (norms[k] > 1e-200 && rest > std::max(rounding, needed * needed)) {
      kept.push_back(k);
      rank.independent.push_back(index);
      continue;
    }
    Dependence dependence{index, {}};
    constexpr double noticeable = 0.02;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (std::abs(share[static_cast<Eigen::Index>(i)]) > noticeable)
        dependence.on.push_back(candidates[static_cast<std::size_t>(kept[i])]);
    rank.dependent.push_back(std::move(dependence));
  }
  std::sort(rank.independent.begin(), rank.independent.end());
  return rank;
}

}  // namespace qvgen::calibrate
