// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "cli/suggestion.h"
#include "compare/measure.h"
#include "pipeline/lines_of_json.h"
#include "verify/counts_json.h"

namespace qvgen::cli {
namespace {

using nlohmann::ordered_json;
using Row = TableRow;

/// Behind the names, in the order of counts_columns().
const Row table_header{"mul",      "add",      "div", "sqrt", "sincos", "atan2", "fewest mul+add",
                       "(sincos)", "error/ulp"};

Row numbers_of(const ordered_json& entry) {
  const dag::OperationCounts c = verify::counts_from_json(entry.at("emitted"));
  Row row;
  for (const int n : {c.multiplications, c.additions, c.divisions, c.roots, c.sine_cosines, c.arctangents})
    row.push_back(std::to_string(n));
  if (entry.contains("fewest_operations")) {
    const dag::OperationCounts f = verify::counts_from_json(entry.at("fewest_operations"));
    row.push_back(std::to_string(f.multiplications + f.additions));
    row.push_back(std::to_string(f.sine_cosines));
  } else {
    row.insert(row.end(), {"", ""});
  }
  row.push_back(entry.contains("largest_error_ulp") ? entry.at("largest_error_ulp").dump() : "");
  return row;
}

/// The places of the wanted columns.
std::vector<std::size_t> places_of(const std::vector<std::string>& columns) {
  const auto& all = counts_columns();
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (columns.empty() || std::find(columns.begin(), columns.end(), all[i]) != columns.end())
      places.push_back(i);
  return places;
}

constexpr std::size_t bracketed = 7;  ///< belongs to the column before it

class CountsTable {
 public:
  CountsTable(ReportFormat format, const std::vector<std::string>& columns)
      : format_(format), places_(places_of(columns)), table_{{{"robot", "function"}}, 2} {
    for (const std::size_t i : places_)
      table_.rows.front().push_back(format == ReportFormat::csv ? counts_columns()[i] : table_header[i]);
  }
  void add(const std::string& robot, const std::string& function, const ordered_json& entry) {
    const Row numbers = numbers_of(entry);
    Row row{robot, function};
    for (const std::size_t i : places_) {
      const bool brackets = i == bracketed && format_ != ReportFormat::csv && !numbers[i].empty();
      row.push_back(brackets ? "(" + numbers[i] + ")" : numbers[i]);
    }
    table_.rows.push_back(std::move(row));
  }
  [[nodiscard]] std::string text() const { return text_of(table_, format_); }

 private:
  ReportFormat format_;
  std::vector<std::size_t> places_;
  Table table_;
};

bool is_function(const ordered_json& entry) { return entry.is_object() && entry.contains("emitted"); }

bool is_wanted(const std::string& name, const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::vector<std::string> functions_of(const ordered_json& counts) {
  std::vector<std::string> functions;
  for (const auto& [robot, entries] : counts.items())
    for (const auto& [name, entry] : entries.items())
      if (is_function(entry) && std::find(functions.begin(), functions.end(), name) == functions.end())
        functions.push_back(name);
  return functions;
}

}  // namespace

const std::vector<std::string>& counts_columns() {
  static const std::vector<std::string> names{"mul",   "add",    "div",           "sqrt",     "sincos",
                                              "atan2", "fewest", "fewest_sincos", "error_ulp"};
  return names;
}

void check(const CountsFilter& filter, const ordered_json& counts) {
  check_names("there are no operation counts of a robot", filter.robots, keys_of(counts));
  check_names("--functions: there is no", filter.functions, functions_of(counts));
}

ordered_json filtered(const ordered_json& counts, const CountsFilter& filter) {
  ordered_json result = ordered_json::object();
  for (const auto& [robot, entries] : counts.items()) {
    if (!is_wanted(robot, filter.robots)) continue;
    ordered_json kept = ordered_json::object();
    for (const auto& [name, entry] : entries.items())
      if (filter.functions.empty() || (is_function(entry) && is_wanted(name, filter.functions)))
        kept[name] = entry;
    if (!kept.empty()) result[robot] = kept;
  }
  return result;
}

std::string report(const ordered_json& counts, ReportFormat format, bool forms,
                   const std::vector<std::string>& columns) {
  if (format == ReportFormat::json) return lines_of_json(counts);
  CountsTable table(format, columns);
  for (const auto& [robot, functions] : counts.items())
    for (const auto& [function, entry] : functions.items()) {
      if (!is_function(entry)) continue;
      table.add(robot, function, entry);
      // Competing forms of a function; the steps of one that has several.
      for (const char* parts : {"forms", "steps"})
        if (forms && entry.contains(parts))
          for (const auto& [name, part] : entry.at(parts).items())
            table.add(robot, "  " + name, ordered_json{{"emitted", part}});
    }
  return table.text();
}

namespace {

struct Change {
  std::string robot, function;
  ordered_json before, after;  ///< null where there is none
};

std::vector<Change> changes_of(const ordered_json& before, const ordered_json& after) {
  std::vector<Change> list;
  const auto entry_of = [](const ordered_json& counts, const std::string& robot,
                           const std::string& function) {
    const bool there = counts.contains(robot) && counts.at(robot).contains(function);
    return there ? counts.at(robot).at(function) : ordered_json();
  };
  const auto add = [&](const std::string& robot, const std::string& function) {
    const ordered_json old = entry_of(before, robot, function), now = entry_of(after, robot, function);
    const bool same = is_function(old) && is_function(now) && numbers_of(old) == numbers_of(now);
    if (!same && (is_function(old) || is_function(now))) list.push_back({robot, function, old, now});
  };
  for (const auto& [robot, functions] : after.items())
    for (const auto& [function, entry] : functions.items()) add(robot, function);
  for (const auto& [robot, functions] : before.items())
    for (const auto& [function, entry] : functions.items())
      if (!after.contains(robot) || !after.at(robot).contains(function)) add(robot, function);
  return list;
}

double cost_of(const ordered_json& entry) {
  return compare::cost(verify::counts_from_json(entry.at("emitted")));
}

std::string kind_of(const Change& change) {
  if (!is_function(change.before)) return "new";
  if (!is_function(change.after)) return "gone";
  const double before = cost_of(change.before), after = cost_of(change.after);
  return after < before ? "cheaper" : after > before ? "dearer" : "as dear";
}

std::string summary(const std::vector<Change>& list) {
  std::map<std::string, int> kinds;
  for (const Change& change : list) ++kinds[kind_of(change)];
  std::string text =
      std::to_string(list.size()) + (list.size() == 1 ? " function differs" : " functions differ");
  for (const char* kind : {"cheaper", "dearer", "as dear", "new", "gone"})
    if (kinds.contains(kind)) text += fmt::format(", {} {}", kinds[kind], kind);
  return text + "\n";
}

/// For people "before -> after" in a cell, for programs two columns.
void append_cells(Row& row, const std::string& before, const std::string& after, ReportFormat format) {
  const bool both = !before.empty() && !after.empty() && before != after;
  if (format == ReportFormat::csv)
    row.insert(row.end(), {before, after});
  else
    row.push_back(both ? before + " -> " + after : after.empty() ? before : after);
}

}  // namespace

std::string changes(const ordered_json& before, const ordered_json& after, ReportFormat format,
                    const std::vector<std::string>& columns) {
  const std::vector<Change> list = changes_of(before, after);
  if (format == ReportFormat::json) {
    ordered_json json = ordered_json::object();
    for (const Change& change : list)
      json[change.robot][change.function] = {{"before", change.before}, {"after", change.after}};
    return json.dump(1) + "\n";
  }
  const std::vector<std::size_t> places = places_of(columns);
  Table table{{{"robot", "function", "change"}}, 3};
  for (const std::size_t i : places) {
    const std::string& name = counts_columns()[i];
    if (format == ReportFormat::csv)
      table.rows.front().insert(table.rows.front().end(), {name + "_before", name + "_after"});
    else
      table.rows.front().push_back(table_header[i]);
  }
  const Row nothing(counts_columns().size(), "");
  for (const Change& change : list) {
    const Row old = is_function(change.before) ? numbers_of(change.before) : nothing;
    const Row now = is_function(change.after) ? numbers_of(change.after) : nothing;
    Row row{change.robot, change.function, kind_of(change)};
    for (const std::size_t i : places) append_cells(row, old[i], now[i], format);
    table.rows.push_back(std::move(row));
  }
  if (format == ReportFormat::csv) return text_of(table, format);
  return (list.empty() ? "" : text_of(table, format) + "\n") + summary(list);
}

}  // namespace qvgen::cli
