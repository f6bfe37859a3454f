// SPDX-License-Identifier: MIT
#include "measured/header.h"

#include <algorithm>

#include <fmt/format.h>

#include "description/names.h"
#include "description/plain_text.h"

namespace qvgen::measured {
namespace {

using description::Diagnostic;

/// A header's cell taken apart: "q1 [deg]" or "q1 (deg)".
struct Title {
  std::string_view name;
  std::optional<std::string_view> unit;
};

Title title_of(std::string_view cell) {
  if (cell.empty() || (cell.back() != ']' && cell.back() != ')')) return {cell, std::nullopt};
  const std::size_t open = cell.rfind(cell.back() == ']' ? '[' : '(');
  if (open == std::string_view::npos) return {cell, std::nullopt};
  return {trimmed(cell.substr(0, open)), trimmed(cell.substr(open + 1, cell.size() - open - 2))};
}

bool is_called(const Wanted& wanted, std::string_view name) {
  return wanted.name == name ||
         std::find(wanted.others.begin(), wanted.others.end(), name) != wanted.others.end();
}

std::vector<std::string> names_of(const std::vector<Wanted>& wanted) {
  std::vector<std::string> names;
  for (const Wanted& each : wanted) {
    names.push_back(each.name);
    names.insert(names.end(), each.others.begin(), each.others.end());
  }
  return names;
}

std::string list_of(const std::vector<Wanted>& wanted) {
  constexpr std::size_t most = 24;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, wanted.size()); ++i)
    text += (text.empty() ? "" : ", ") + wanted[i].name;
  return text + (wanted.size() > most ? ", ..." : "");
}

Unit default_unit(Quantity quantity, const TableOptions& options) {
  if (quantity == Quantity::angle) return {quantity, options.angle_unit};
  if (quantity == Quantity::length) return {quantity, options.length_unit};
  return {quantity};
}

/// Reads one header after the other; keeps what all of them share.
class HeaderReader {
 public:
  HeaderReader(std::string_view line, const std::vector<Wanted>& wanted, const TableOptions& options,
               const Diagnostic& place, std::vector<Diagnostic>& mistakes)
      : line_(line), wanted_(wanted), options_(options), place_(place), mistakes_(mistakes) {}

  HeaderColumn column(std::string_view cell) {
    const Title title = title_of(cell);
    const auto found = std::find_if(wanted_.begin(), wanted_.end(),
                                    [&](const Wanted& each) { return is_called(each, title.name); });
    if (found == wanted_.end()) {
      say_unknown(cell, title.name);
      return {};
    }
    const auto index = static_cast<std::size_t>(found - wanted_.begin());
    if (std::find(met_.begin(), met_.end(), index) != met_.end())
      say(cell, fmt::format("two columns are '{}'", found->name), "leave one of them");
    met_.push_back(index);
    return {index, unit(cell, title, *found), title.unit.has_value()};
  }

  void say_missing() {
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      if (wanted_[i].required && std::find(met_.begin(), met_.end(), i) == met_.end())
        say(line_, fmt::format("there is no column '{}'", wanted_[i].name),
            fmt::format("add it to the header; it holds {}", name_of(wanted_[i].quantity)));
  }

 private:
  void say(std::string_view cell, std::string message, std::string hint) {
    mistakes_.push_back(mistake_at(place_, line_, cell, std::move(message), std::move(hint)));
  }

  void say_unknown(std::string_view cell, std::string_view name) {
    const auto& ignored = options_.ignored;
    if (std::find(ignored.begin(), ignored.end(), name) != ignored.end()) return;
    const std::string near = description::nearest(name, names_of(wanted_));
    say(cell, fmt::format("column '{}' is not known", description::printable(name)),
        near.empty() ? "known columns are " + list_of(wanted_) : "did you mean '" + near + "'?");
    if (!options_.others_are_mistakes) mistakes_.back().severity = Diagnostic::note;
  }

  Unit unit(std::string_view cell, const Title& title, const Wanted& wanted) {
    if (!title.unit) return default_unit(wanted.quantity, options_);
    const std::optional<Unit> unit = unit_of(*title.unit);
    if (unit && unit->quantity == wanted.quantity) return *unit;
    const std::string shown = description::printable(*title.unit);
    say(cell,
        unit ? fmt::format("'{}' is {}, which is not measured in {}", wanted.name, name_of(wanted.quantity),
                           shown)
             : fmt::format("'{}' is no unit that is known", shown),
        "write " + units_text(wanted.quantity));
    return default_unit(wanted.quantity, options_);
  }

  std::string_view line_;
  const std::vector<Wanted>& wanted_;
  const TableOptions& options_;
  const Diagnostic& place_;
  std::vector<Diagnostic>& mistakes_;
  std::vector<std::size_t> met_;
};

/// Counts the characters of UTF-8 text.
int characters(std::string_view text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

}  // namespace

Diagnostic mistake_at(const Diagnostic& place, std::string_view line, std::string_view cell,
                      std::string message, std::string hint) {
  Diagnostic mistake = place;
  const bool inside = cell.data() >= line.data() && cell.data() <= line.data() + line.size();
  mistake.column =
      inside ? 1 + characters(line.substr(0, static_cast<std::size_t>(cell.data() - line.data()))) : 1;
  mistake.message = std::move(message);
  mistake.hint = std::move(hint);
  return mistake;
}

std::vector<HeaderColumn> read_header(const std::vector<std::string_view>& cells, std::string_view line,
                                      const std::vector<Wanted>& wanted, const TableOptions& options,
                                      const Diagnostic& place, std::vector<Diagnostic>& mistakes) {
  HeaderReader reader(line, wanted, options, place, mistakes);
  std::vector<HeaderColumn> columns;
  for (const std::string_view cell : cells) columns.push_back(reader.column(cell));
  reader.say_missing();
  return columns;
}

}  // namespace qvgen::measured
