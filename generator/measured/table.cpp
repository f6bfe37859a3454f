// SPDX-License-Identifier: MIT
// Lines come into one buffer, cells are views into it, and numbers go straight into the wanted columns.
#include "measured/table.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "description/plain_text.h"

namespace qvgen::measured {
namespace {

using description::Diagnostic;

/// Lines of a stream, without what comments and line ends add. A line that is too long ends the reading.
class Lines {
 public:
  explicit Lines(std::istream& stream) : stream_(stream), buffer_(longest_line + 1) {}

  /// Reads the next line; false at the end.
  bool next() {
    if (!stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) {
      too_long_ = stream_.gcount() == static_cast<std::streamsize>(longest_line);
      return false;
    }
    ++number_;
    const auto read = static_cast<std::size_t>(stream_.gcount());
    line_ = std::string_view(buffer_.data(), read - (stream_.eof() ? 0 : 1));
    if (number_ == 1 && line_.substr(0, 3) == "\xef\xbb\xbf") line_.remove_prefix(3);
    const std::size_t comment = line_.find_first_of("#%");
    comment_ = comment == std::string_view::npos ? std::string_view() : line_.substr(comment + 1);
    text_ = line_.substr(0, comment);
    blank_ = trimmed(text_).empty();
    return true;
  }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool too_long() const { return too_long_; }
  [[nodiscard]] bool blank() const { return blank_; }            ///< but for a comment
  [[nodiscard]] std::string_view text() const { return text_; }  ///< without its comment
  [[nodiscard]] std::string_view comment() const { return comment_; }

 private:
  std::istream& stream_;
  std::vector<char> buffer_;
  std::string_view line_, text_, comment_;
  int number_ = 0;
  bool too_long_ = false, blank_ = true;
};

class TableReader {
 public:
  TableReader(std::istream& stream, const std::string& file, const std::vector<Wanted>& wanted,
              const TableOptions& options)
      : lines_(stream), wanted_(wanted), options_(options) {
    result_.table.file = file;
    place_.file = file;
  }

  TableResult read() {
    if (read_header_line()) {
      while (has_room() && (first_is_row_ || lines_.next())) {
        first_is_row_ = false;
        if (!lines_.blank()) read_row();
      }
      finish();
    }
    if (lines_.too_long()) {
      place_.line = lines_.number() + 1;
      say("a line of more than " + std::to_string(longest_line) + " characters", "is this a table of text?");
    }
    return std::move(result_);
  }

 private:
  void say(std::string message, std::string hint, std::string_view cell = {}) {
    result_.diagnostics.push_back(
        mistake_at(place_, lines_.text(), cell, std::move(message), std::move(hint)));
  }

  /// Reads a header, from the first line with text or, if that is a row already, from the comment before it.
  bool read_header_line() {
    std::string comment;
    int line_of_comment = 0;
    while (lines_.next() && lines_.blank())
      if (!trimmed(lines_.comment()).empty()) {
        comment = std::string(trimmed(lines_.comment()));
        line_of_comment = lines_.number();
      }
    place_.line = std::max(1, lines_.number());
    if (lines_.blank()) {
      if (!lines_.too_long()) say("the table has no rows", "write a header and a row for each measurement");
      return false;
    }
    separator_ = separator_of(lines_.text());
    split(lines_.text(), separator_, cells_);
    if (!is_row()) return take_header(lines_.text());
    const std::size_t count = cells_.size();
    split(comment, separator_of(comment), cells_);
    first_is_row_ = true;
    if (cells_.size() == count) {
      place_.line = line_of_comment;
      return take_header(comment);
    }
    say("the table has no header: its first line is numbers",
        "name the columns in a line above, such as " + wanted_.front().name + ", ...");
    return false;
  }

  bool is_row() const {
    return std::all_of(cells_.begin(), cells_.end(),
                       [](std::string_view cell) { return number_of(cell).has_value(); });
  }

  bool take_header(std::string_view line) {
    if (cells_.size() > 1 && cells_.back().empty()) cells_.pop_back();
    header_ = read_header(cells_, line, wanted_, options_, place_, result_.diagnostics);
    slots_.assign(wanted_.size(), HeaderColumn::not_wanted);
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      for (const HeaderColumn& column : header_)
        if (column.wanted == i && slots_[i] == HeaderColumn::not_wanted) {
          slots_[i] = result_.table.columns.size();
          result_.table.columns.push_back({wanted_[i].name, {}, column.stated});
        }
    return result_.good();
  }

  [[nodiscard]] bool has_room() {
    const std::size_t columns = std::max<std::size_t>(1, result_.table.columns.size());
    if (result_.table.rows() < most_numbers / columns) return true;
    say("the table has too many rows", fmt::format("use every second one; {} fit", most_numbers / columns));
    return false;
  }

  void read_row() {
    place_.line = lines_.number();
    split(lines_.text(), separator_, cells_);
    // A separator at the end of each line, as spreadsheets leave it.
    if (cells_.size() == header_.size() + 1 && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() != header_.size()) {
      return count_mistake([&] {
        say(fmt::format("{} cells where the header has {} columns", cells_.size(), header_.size()),
            "write one number for each column");
      });
    }
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (header_[i].wanted != HeaderColumn::not_wanted) read_cell(cells_[i], header_[i]);
    result_.table.lines.push_back(place_.line);
  }

  void read_cell(std::string_view cell, const HeaderColumn& column) {
    const Wanted& wanted = wanted_[column.wanted];
    std::optional<double> value = number_of(cell);
    const bool finite = value && std::isfinite(*value);
    if (!finite && wanted.may_miss && (cell.empty() || (value && std::isnan(*value))))
      value = std::nan("");
    else if (!finite)
      count_mistake([&] { say_no_number(cell, wanted, value.has_value()); });
    auto& values = result_.table.columns[slots_[column.wanted]].values;
    values.push_back(value.value_or(0) * column.unit.factor + column.unit.offset);
  }

  void say_no_number(std::string_view cell, const Wanted& wanted, bool is_number) {
    const std::string shown(description::printable(cell.substr(0, 40)));
    if (cell.empty())
      say(fmt::format("'{}' is empty", wanted.name), "write a number, or leave the row out");
    else if (is_number)
      say(fmt::format("'{}' is {}", wanted.name, shown), "leave the row out");
    else
      say(fmt::format("'{}' of '{}' is no number", shown, wanted.name),
          cell.find(',') != std::string_view::npos ? "write decimals with a point"
                                                   : "write a number such as 0.125",
          cell);
  }

  /// Says a mistake of a row unless there were many already.
  template <class Say>
  void count_mistake(const Say& say_it) {
    if (++mistakes_ <= most_mistakes) say_it();
  }

  void finish() {
    if (mistakes_ > most_mistakes)
      say(fmt::format("and {} more mistakes of rows", mistakes_ - most_mistakes), "repair those above first");
    if (mistakes_ == 0 && result_.table.rows() < options_.fewest_rows)
      say(fmt::format("{} rows are too few", result_.table.rows()),
          fmt::format("give at least {}", options_.fewest_rows));
  }

  Lines lines_;
  const std::vector<Wanted>& wanted_;
  const TableOptions& options_;
  TableResult result_;
  Diagnostic place_;
  Separator separator_ = Separator::comma;
  std::vector<std::string_view> cells_;
  std::vector<HeaderColumn> header_;
  std::vector<std::size_t> slots_;  ///< of each wanted column in the table
  std::size_t mistakes_ = 0;
  bool first_is_row_ = false;
};

TableResult failed(const std::string& file, const std::string& message, const std::string& hint) {
  return {{file, {}, {}}, {{file, 1, 1, Diagnostic::error, message, hint}}};
}

}  // namespace

const std::vector<double>* Table::find(std::string_view name) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& each) { return each.name == name; });
  return found == columns.end() ? nullptr : &found->values;
}

bool TableResult::good() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(),
                      [](const Diagnostic& each) { return each.severity == Diagnostic::error; });
}

TableResult read_table(std::istream& stream, const std::string& file, const std::vector<Wanted>& wanted,
                       const TableOptions& options) {
  return TableReader(stream, file, wanted, options).read();
}

TableResult read_table(const std::filesystem::path& path, const std::vector<Wanted>& wanted,
                       const TableOptions& options) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return failed(path.string(), "this is a folder", "give a file of measurements");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    return failed(path.string(), "the file cannot be read: " + std::generic_category().message(errno),
                  "give a table with a header such as q1, q2, ... and a row for each measurement");
  return read_table(stream, path.string(), wanted, options);
}

}  // namespace qvgen::measured
