// SPDX-License-Identifier: MIT
#include "compare/comparison.h"

#include <algorithm>

namespace qvgen::compare {
namespace {

std::string result_of(const dag::Function& function) {
  const std::string& first = function.outputs.front().name;
  if (first == "w") return "quaternion";
  if (first == "r11") return "matrix";
  return first == "v1_1" ? "6 x n" : "forces";
}

Row row_of(const std::string& robot, const Formulation& formulation, Level level, const Measured& measured) {
  return {robot,          formulation.name,      result_of(measured.function),
          level,          measured.counts,       measured.constants,
          measured.alive, cost(measured.counts), 0};
}

void rank(std::vector<Row>& rows) {
  for (Row& row : rows)
    row.rank = 1 + static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const Row& other) {
                 return other.level == row.level && other.cost < row.cost;
               }));
}

bool is_wanted(const Formulation& formulation, const Request& request) {
  const auto& names = request.formulations;
  return names.empty() || std::find(names.begin(), names.end(), formulation.name) != names.end();
}

}  // namespace

std::vector<Row> compare(const model::Robot& robot, const Request& request) {
  const Subject subject(robot, request.what);
  std::vector<Level> levels = request.levels;
  if (levels.empty()) levels = {Level::textbook, Level::specialised, Level::optimised};
  std::vector<Row> rows;
  for (const Level level : levels)
    for (const Formulation& formulation : formulations(request.what)) {
      if (!is_wanted(formulation, request) || (!formulation.run && level != Level::optimised)) continue;
      rows.push_back(row_of(robot.name, formulation, level, measure(subject, formulation, level)));
    }
  rank(rows);
  return rows;
}

std::vector<std::string> formulation_names(What what) {
  std::vector<std::string> names;
  for (const Formulation& formulation : formulations(what)) names.push_back(formulation.name);
  return names;
}

}  // namespace qvgen::compare
