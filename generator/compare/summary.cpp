// SPDX-License-Identifier: MIT
#include "compare/summary.h"

#include <algorithm>

namespace qvgen::compare {

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  const double median = n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
  return {values.front(), median, values.back()};
}

std::vector<Ratios> pairs_against_matrices(const std::vector<Row>& rows) {
  std::vector<Ratios> ratios;
  for (const Row& pairs : rows) {
    if (pairs.formulation != "pairs") continue;
    const auto matrices = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return row.robot == pairs.robot && row.level == pairs.level && row.formulation == "dh";
    });
    if (matrices == rows.end()) continue;
    auto place =
        std::find_if(ratios.begin(), ratios.end(), [&](const Ratios& r) { return r.robot == pairs.robot; });
    if (place == ratios.end()) place = ratios.insert(place, {pairs.robot, {}});
    place->by_level[pairs.level] = pairs.cost / matrices->cost;
  }
  return ratios;
}

std::vector<ClassSummary> by_class(const std::vector<Ratios>& ratios,
                                   const std::map<std::string, std::string>& classes) {
  std::map<std::string, std::map<Level, std::vector<double>>> values;
  std::map<std::string, int> robots;
  for (const Ratios& each : ratios) {
    const auto workspace = classes.find(each.robot);
    if (workspace == classes.end()) continue;
    ++robots[workspace->second];
    for (const auto& [level, ratio] : each.by_level) values[workspace->second][level].push_back(ratio);
  }
  std::vector<ClassSummary> summaries;
  for (const auto& [workspace, by_level] : values) {
    ClassSummary summary{workspace, robots[workspace], {}};
    for (const auto& [level, list] : by_level) summary.by_level[level] = spread_of(list);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

}  // namespace qvgen::compare
