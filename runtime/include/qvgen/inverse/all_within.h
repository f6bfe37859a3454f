// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>

#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/within.h>

namespace qvgen {
namespace inverse {

/// Status of a set within limits. A row inside may be among those that an incomplete set lacks.
inline Status status_within(Status all, bool is_empty, bool is_marked) {
  if (all == Status::invalid || all == Status::incomplete) return all;
  return is_empty ? Status::unreachable : is_marked ? Status::singular : Status::solved;
}

/// Puts the rows that are inside, their representatives next to the seed, one behind the other, with the
/// squares of their distances from the seed. Returns how many there are.
template <int dof, int capacity>
int keep_within(const Solutions<dof, capacity>& found, const Within<dof>& within, Solution<dof>* kept,
                double* squares) {
  constexpr bool is_eight_long = sizeof(Solution<dof>) == 8 * sizeof(double) && (dof == 6 || dof == 7);
  if constexpr (is_eight_long) {
    if (const RowsWithin wide = widest_rows_within(); wide != nullptr && !found.empty())
      return wide(within.table(), dof, found.begin()->q.data(), found.size(), kept->q.data(), squares);
  }
  int count = 0;
  for (const Solution<dof>& row : found) {
    // A row that is not inside is overwritten by the next: a jump would be guessed wrong too often.
    kept[count] = row;
    count += static_cast<int>(within.take(kept[count].q, squares[count]));
  }
  return count;
}

}  // namespace inverse

/// Every solution within limits, whole turns counted: a joint that may turn from -360 to 360 degrees has each
/// angle twice, six such joints have each solution 64 times. They are not stored but made when they are asked
/// for, so that none is ever missing for want of room:
///
///     for (const auto& row : found) use(row.q);            // or std::copy(found.begin(), found.end(), ...)
///     found.for_each([&](const auto& row) { use(row.q); });  // the same rows; faster, where there are many
///
/// Branch by branch; each branch begins with its row nearest to the centre, a joint at a time. A joint that
/// has not two finite limits has the one representative nearest to the centre.
template <int dof, int capacity>
class AllWithinLimits {
 public:
  Status status = Status::unreachable;  ///< unreachable: there are solutions but none inside
  inverse::Effort effort;

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Solution<dof>;
    using difference_type = std::ptrdiff_t;
    using pointer = const Solution<dof>*;
    using reference = const Solution<dof>&;

    Iterator(const AllWithinLimits& all, int branch) : all_(&all), branch_(branch) { begin_branch(); }
    const Solution<dof>& operator*() const { return row_; }
    const Solution<dof>* operator->() const { return &row_; }
    /// Counts through the turns of all joints like an odometer.
    Iterator& operator++() {
      const Turns& turns = all_->turns_[branch_];
      for (int i = 0; i < turns.last; ++i) {
        const bool is_more = ++index_[i] < turns.count(i);
        if (!is_more) index_[i] = 0;
        row_.q[i] = all_->value(branch_, i, index_[i]);
        if (is_more) return *this;
      }
      ++branch_;
      begin_branch();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) {
      return a.branch_ == b.branch_ && std::equal(a.index_, a.index_ + dof, b.index_);
    }
    friend bool operator!=(const Iterator& a, const Iterator& b) { return !(a == b); }

   private:
    void begin_branch() {
      if (branch_ < all_->branch_count_) row_ = all_->rows_[branch_];
    }

    const AllWithinLimits* all_;
    int branch_;
    int index_[dof] = {};
    Solution<dof> row_;
  };

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, branch_count_}; }
  [[nodiscard]] bool empty() const { return branch_count_ == 0; }
  /// How many rows there are; the largest number that there is if there are more.
  [[nodiscard]] std::size_t size() const {
    constexpr auto most = std::numeric_limits<std::size_t>::max();
    double sum = 0;
    for (int k = 0; k < branch_count_; ++k) sum += turns_[k].rows();
    return sum < static_cast<double>(most) ? static_cast<std::size_t>(sum) : most;
  }

  /// How many branches have a row inside, and the row of each that is nearest to the centre.
  [[nodiscard]] int branches() const { return branch_count_; }
  [[nodiscard]] const Solution<dof>& nearest_to_centre(int branch) const { return rows_[branch]; }

  /// Calls `visit(row)` for all rows, in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int k = 0; k < branch_count_; ++k) {
      Solution<dof> row = rows_[k];
      turns_of<dof - 1>(k, row, visit);
    }
  }

  /// For `within_limits`: adds the rows of all solutions that have one inside.
  explicit AllWithinLimits(const inverse::Within<dof>& within) : within_(within) {}
  void add(const Solutions<dof, capacity>& found) {
    double squares[capacity];
    branch_count_ = inverse::keep_within(found, within_, rows_, squares);
    const bool has_turns = within_.has_turns();
    bool is_marked = false;
    for (int k = 0; k < branch_count_; ++k) {
      turns_[k].last = 0;
      if (has_turns) count_turns(rows_[k], turns_[k]);
      is_marked = is_marked || rows_[k].continuum;
    }
    effort = found.effort;
    status = inverse::status_within(found.status, empty(), is_marked);
  }
  [[nodiscard]] const inverse::Within<dof>& within() const { return within_; }

 private:
  /// Values of a joint that are kept; those beyond are computed.
  static constexpr int kept = 4;

  /// How many whole turns further the joints of one row may go.
  struct Turns {
    int last;                    ///< the joints in front of this one may turn further
    int below[dof], above[dof];  ///< by how many turns, of these joints
    double values[dof][kept];

    [[nodiscard]] int count(int joint) const { return below[joint] + above[joint] + 1; }
    [[nodiscard]] double rows() const {
      double product = 1;
      for (int i = 0; i < last; ++i) product *= count(i);
      return product;
    }
    /// The row's own angle, then alternately above and below for as long as there are both.
    [[nodiscard]] int at(int joint, int index) const {
      const int fewer = below[joint] < above[joint] ? below[joint] : above[joint];
      if (index > 2 * fewer) return above[joint] > below[joint] ? index - fewer : fewer - index;
      return index % 2 == 1 ? (index + 1) / 2 : -index / 2;
    }
  };

  void count_turns(const Solution<dof>& row, Turns& turns) const {
    for (int i = 0; i < dof; ++i) {
      within_.further_turns(i, row.q[i], turns.below[i], turns.above[i]);
      const int count = turns.count(i);
      if (count > 1) turns.last = i + 1;
      turns.values[i][0] = row.q[i];
      for (int index = 1; index < kept && index < count; ++index)
        turns.values[i][index] = within_.turned(i, row.q[i], turns.at(i, index));
    }
  }

  [[nodiscard]] double value(int branch, int joint, int index) const {
    const Turns& turns = turns_[branch];
    return index < kept ? turns.values[joint][index]
                        : within_.turned(joint, rows_[branch].q[joint], turns.at(joint, index));
  }

  template <int joint, class Visit>
  void turns_of(int branch, Solution<dof>& row, const Visit& visit) const {
    if constexpr (joint < 0) {
      visit(static_cast<const Solution<dof>&>(row));
    } else if (joint >= turns_[branch].last) {
      turns_of<joint - 1>(branch, row, visit);
    } else {
      const int count = turns_[branch].count(joint);
      for (int index = 0; index < count; ++index) {
        row.q[joint] = value(branch, joint, index);
        turns_of<joint - 1>(branch, row, visit);
      }
    }
  }

  inverse::Within<dof> within_;
  int branch_count_ = 0;
  Solution<dof> rows_[capacity];  // both are filled as far as the count
  Turns turns_[capacity];
};

}  // namespace qvgen
