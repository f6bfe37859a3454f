// SPDX-License-Identifier: MIT
#include "report/times.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "compare/measure.h"
#include "pipeline/files.h"

namespace qvgen::report {
namespace {

using compare::What;
using nlohmann::ordered_json;

/// Which quantity a row is of, by what it gives.
What what_of(const std::string& result) {
  if (result == "forces") return What::dynamics;
  return result == "6 x n" ? What::jacobian : What::forward;
}

const std::string& name_of(What what) { return compare::what_names()[static_cast<std::size_t>(what)]; }

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + " " + why +
                           ": write it with qvgen compare --time --format json > FILE");
}

void add_rows(const ordered_json& json, Times& times) {
  for (const ordered_json& row : json.at("rows")) {
    if (!row.contains("nanoseconds")) continue;
    const ordered_json& time = row.at("nanoseconds");
    times.robots[row.at("robot")].push_back({what_of(row.at("result")), row.at("level"),
                                             row.at("formulation"), time.at("median"),
                                             time.at("lower_quartile"), time.at("upper_quartile")});
  }
}

void add_file(const std::filesystem::path& file, Times& times) {
  const auto text = pipeline::content_of(file);
  if (!text) throw std::runtime_error("there is no file " + file.string());
  try {
    const ordered_json json = ordered_json::parse(*text);
    if (!json.contains("machine")) refuse(file, "has no times");
    const std::string machine = json.at("machine");
    if (!times.machine.empty() && times.machine != machine)
      throw std::runtime_error(file.string() + " was measured on another machine than the file before it: " +
                               machine + ", not " + times.machine);
    times.machine = machine;
    add_rows(json, times);
  } catch (const ordered_json::exception&) {
    refuse(file, "is no file of times");
  }
}

Cell time_cell(const std::vector<MeasuredTime>& all, const std::string& formulation,
               const std::string& level) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const MeasuredTime& time) {
    return time.formulation == formulation && time.level == level;
  });
  if (found == all.end()) return {"–", true};
  return {fmt::format("{:.1f} <small>({:.1f} to {:.1f})</small>", found->median, found->lower, found->upper),
          true};
}

std::string level_title(const std::string& level) {
  return level == "textbook"      ? "as a textbook has it"
         : level == "specialised" ? "specialised"
                                  : "after all passes";
}

}  // namespace

std::vector<MeasuredTime> Times::of(const std::string& robot, What what) const {
  std::vector<MeasuredTime> result;
  const auto place = robots.find(robot);
  if (place == robots.end()) return result;
  std::copy_if(place->second.begin(), place->second.end(), std::back_inserter(result),
               [&](const MeasuredTime& time) { return time.what == what; });
  return result;
}

Times read_times(const std::vector<std::filesystem::path>& files) {
  Times times;
  for (const auto& file : files) add_file(file, times);
  return times;
}

std::string times_html(const Times& times, const std::string& robot, What what) {
  const std::vector<MeasuredTime> all = times.of(robot, what);
  if (all.empty()) return "";
  HtmlTable table{"Nanoseconds a call, the median and the quartiles of many, measured on: " +
                      escaped(times.machine) + ".",
                  {text_cell("formulation")},
                  {},
                  "times-" + name_of(what)};
  for (const std::string& level : compare::level_names()) table.head.push_back({level_title(level), true});
  std::vector<std::string> told;
  for (const MeasuredTime& time : all) {
    if (std::find(told.begin(), told.end(), time.formulation) != told.end()) continue;
    told.push_back(time.formulation);
    std::vector<Cell> row{text_cell(time.formulation)};
    for (const std::string& level : compare::level_names())
      row.push_back(time_cell(all, time.formulation, level));
    table.rows.push_back(row);
  }
  return html(table);
}

ordered_json times_json(const Times& times, const std::string& robot) {
  const auto place = times.robots.find(robot);
  if (place == times.robots.end()) return nullptr;
  ordered_json json{{"machine", times.machine}};
  for (const MeasuredTime& time : place->second)
    json[name_of(time.what)][time.level][time.formulation] = time.median;
  return json;
}

}  // namespace qvgen::report
