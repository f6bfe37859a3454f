// SPDX-License-Identifier: MIT
#include "calibrate/interval.h"

#include <algorithm>

#include <fmt/format.h>

namespace qvgen::calibrate {
namespace {

constexpr double strong = 0.9;
constexpr std::size_t most_pairs = 8;

struct Pair {
  std::size_t first, second;
  double correlation;
};

/// Returns the pairs of errors of the arm with strong correlations, the strongest first.
std::vector<Pair> pairs_of(const Calibration& found) {
  std::vector<Pair> pairs;
  const auto& covariance = found.covariance;
  for (std::size_t i = 0; i < found.active.size(); ++i)
    for (std::size_t j = i + 1; j < found.active.size(); ++j) {
      const auto& parameters = found.identifiable.model.parameters;
      if (parameters[found.active[i]].nuisance || parameters[found.active[j]].nuisance) continue;
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      const double correlation = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
      if (std::abs(correlation) > strong) pairs.push_back({i, j, correlation});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::abs(a.correlation) > std::abs(b.correlation);
  });
  return pairs;
}

}  // namespace

std::vector<ErrorEstimate> error_estimates(const Calibration& found) {
  std::vector<ErrorEstimate> result;
  const double reach = reach_of_95(found.freedom);
  constexpr double milli = 1e3;
  for (std::size_t i = 0; i < found.active.size(); ++i) {
    const Parameter& each = found.identifiable.model.parameters[found.active[i]];
    if (each.nuisance) continue;
    const auto k = static_cast<Eigen::Index>(i);
    const double value = milli * found.state.values[found.active[i]];
    const double deviation = milli * std::sqrt(found.covariance(k, k));
    result.push_back({each.name, each.turn ? "mrad" : "mm", value, deviation, value - reach * deviation,
                      value + reach * deviation});
  }
  return result;
}

std::vector<std::string> correlated(const Calibration& found) {
  const std::vector<Pair> pairs = pairs_of(found);
  const auto name = [&](std::size_t i) { return found.identifiable.model.parameters[found.active[i]].name; };
  std::vector<std::string> result;
  for (std::size_t i = 0; i < std::min(pairs.size(), most_pairs); ++i)
    result.push_back(fmt::format("{} and {}: correlation {:+.3f}", name(pairs[i].first),
                                 name(pairs[i].second), pairs[i].correlation));
  if (pairs.size() > most_pairs)
    result.push_back(fmt::format("and {} more pairs", pairs.size() - most_pairs));
  return result;
}

}  // namespace qvgen::calibrate
