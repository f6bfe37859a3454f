// SPDX-License-Identifier: MIT
#include "emit/cpp/compact_order.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "emit/cpp/compact_text.h"

namespace qvgen::emit {
namespace {

using Indices = std::vector<StatementIndex>;

/// Which values each statement reads, numbers with names apart: those are in memory anyway.
class Reads {
 public:
  Reads(const std::vector<Code::Value>& values, const std::vector<Assignment>& assignments) {
    for (const Code::Value& value : values) names_.emplace(value.name, names_.size());
    for (const Code::Value& value : values) add(value.expression);
    for (const Assignment& assignment : assignments) add(assignment.expression);
    for (const Code::Value& value : values) is_number_.push_back(is_number(value.expression));
    is_number_.resize(of_.size(), false);
    for (Indices& values_read : of_)
      values_read.erase(std::remove_if(values_read.begin(), values_read.end(),
                                       [this](StatementIndex value) { return is_number_[value]; }),
                        values_read.end());
  }

  [[nodiscard]] std::size_t size() const { return of_.size(); }
  [[nodiscard]] const Indices& of(StatementIndex statement) const { return of_[statement]; }
  [[nodiscard]] bool is_number(StatementIndex statement) const { return is_number_[statement]; }

 private:
  static bool is_number(const std::string& expression) {
    return expression.starts_with(short_number) && expression.find(')') + 1 == expression.size();
  }
  void add(const std::string& expression) {
    Indices read;
    with_words(expression, [&](const std::string& word) {
      const auto name = names_.find(word);
      if (name != names_.end() && std::find(read.begin(), read.end(), name->second) == read.end())
        read.push_back(name->second);
      return word;
    });
    of_.push_back(std::move(read));
  }

  std::map<std::string, std::size_t> names_;
  std::vector<Indices> of_;
  std::vector<bool> is_number_;
};

/// Takes statements one by one, always one that gains most of those whose values are known.
class Scheduler {
 public:
  Scheduler(const Reads& reads, std::size_t values)
      : reads_(reads),
        unread_(reads.size()),
        missing_(reads.size()),
        gain_(reads.size()),
        users_(reads.size()) {
    for (StatementIndex statement = 0; statement < reads.size(); ++statement) {
      missing_[statement] = reads.of(statement).size();
      gain_[statement] = statement < values ? -1 : 0;
      for (const StatementIndex value : reads.of(statement)) users_[value].push_back(statement);
    }
    for (StatementIndex value = 0; value < reads.size(); ++value) {
      unread_[value] = users_[value].size();
      if (unread_[value] == 1) ++gain_[users_[value].front()];
    }
  }

  Indices order() {
    for (StatementIndex statement = 0; statement < reads_.size(); ++statement)
      if (reads_.is_number(statement))
        result_.push_back(statement);
      else if (missing_[statement] == 0)
        ready_.insert(key(statement));
    while (!ready_.empty()) take(ready_.begin()->second);
    return std::move(result_);
  }

 private:
  using Key = std::pair<int, StatementIndex>;

  /// The statement that gains most is first, of equal ones the first.
  [[nodiscard]] Key key(StatementIndex statement) const { return {-gain_[statement], statement}; }

  void take(StatementIndex statement) {
    ready_.erase(key(statement));
    result_.push_back(statement);
    missing_[statement] = taken;
    for (const StatementIndex value : reads_.of(statement))
      if (--unread_[value] == 1) leave_to_last_user(value);
    for (const StatementIndex user : users_[statement])
      if (--missing_[user] == 0) ready_.insert(key(user));
  }
  void leave_to_last_user(StatementIndex value) {
    const Indices& users = users_[value];
    const auto last = *std::find_if(users.begin(), users.end(),
                                    [this](StatementIndex user) { return missing_[user] != taken; });
    const bool was_ready = ready_.erase(key(last)) > 0;
    ++gain_[last];
    if (was_ready) ready_.insert(key(last));
  }

  static constexpr std::size_t taken = std::numeric_limits<std::size_t>::max();

  const Reads& reads_;
  std::vector<std::size_t> unread_, missing_;  ///< uses to come of a value; values that a statement waits for
  std::vector<int> gain_;  ///< values that need be kept no longer after a statement, less the one that is new
  std::vector<Indices> users_;
  std::set<Key> ready_;
  Indices result_;
};

}  // namespace

std::vector<StatementIndex> statement_order(const std::vector<Code::Value>& values,
                                            const std::vector<Assignment>& assignments) {
  return Scheduler(Reads(values, assignments), values.size()).order();
}

}  // namespace qvgen::emit
