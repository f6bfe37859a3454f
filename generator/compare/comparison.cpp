// SPDX-License-Identifier: MIT
#include "compare/comparison.h"

#include <algorithm>
#include <stdexcept>

#include "model/followers.h"

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

/// Numbers of the robot, known or not, are kept.
TimedCode code_of(const dag::Function& function, const model::Robot& robot) {
  const dag::IsFree is_parameter = free_symbols(robot);
  return timed_code(function, [&](const std::string& name) { return is_opaque(name) || is_parameter(name); });
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
  if (model::has_followers(robot))
    throw std::domain_error("a joint follows another: the formulations give each joint a value of its own");
  const Subject subject(robot, request.what);
  std::vector<Level> levels = request.levels;
  if (levels.empty()) levels = {Level::textbook, Level::specialised, Level::optimised};
  std::vector<Row> rows;
  for (const Level level : levels)
    for (const Formulation& formulation : formulations(request.what)) {
      if (!is_wanted(formulation, request) || (!formulation.run && level != Level::optimised)) continue;
      const Measured measured = measure(subject, formulation, level);
      rows.push_back(row_of(robot.name, formulation, level, measured));
      if (request.code) rows.back().code = code_of(measured.function, subject.of(formulation).arm.robot);
    }
  rank(rows);
  return rows;
}

void set_times(std::vector<Row>& rows, const std::vector<Time>& times) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].time = times.at(i);
  for (Row& row : rows) {
    double least = row.time->median;
    for (const Row& other : rows)
      if (other.robot == row.robot && other.level == row.level) least = std::min(least, other.time->median);
    row.time->ratio = row.time->median / least;
  }
}

std::vector<std::string> formulation_names(What what) {
  std::vector<std::string> names;
  for (const Formulation& formulation : formulations(what)) names.push_back(formulation.name);
  return names;
}

}  // namespace qvgen::compare
