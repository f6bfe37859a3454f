// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/row_iterator.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/turns.h>
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
template <int dof_, int capacity>
class AllWithinLimits {
 public:
  static constexpr int dof = dof_;
  Status status = Status::unreachable;  ///< unreachable: there are solutions but none inside
  inverse::Effort effort;

  using Turns = inverse::Turns<dof>;
  using Iterator = inverse::RowIterator<AllWithinLimits>;

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, branches()}; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// How many rows there are; the largest number that there is if there are more.
  [[nodiscard]] std::size_t size() const {
    constexpr auto most = std::numeric_limits<std::size_t>::max();
    double sum = 0;
    for (const Solution<dof>& row : rows_) sum += limits_.representatives(row.q);
    return sum < static_cast<double>(most) ? static_cast<std::size_t>(sum) : most;
  }

  /// How many branches have a row inside, and the row of each that is nearest to the centre.
  [[nodiscard]] int branches() const { return rows_.size(); }
  [[nodiscard]] const Solution<dof>& nearest_to_centre(int branch) const { return rows_[branch]; }

  /// The first row of a branch; makes `turns` ready for those behind it.
  Solution<dof> start(int branch, Turns& turns) const {
    turns.start(limits_, rows_[branch].q);
    return rows_[branch];
  }

  /// Calls `visit(row)` for all rows, in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int branch = 0; branch < branches(); ++branch) {
      Turns turns;
      turns.start(limits_, rows_[branch].q);
      if (turns.is_kept) {
        Solution<dof> row = rows_[branch];
        turns_of<dof - 1>(turns, row, visit);
      } else {
        for (Iterator each(*this, branch); each.branch() == branch; ++each) visit(*each);
      }
    }
  }

  template <std::size_t count>
  AllWithinLimits(const JointLimits<dof>& limits, const std::array<bool, count>& revolute,
                  const Joints<dof>& centre)
      : limits_(limits, revolute), centre_(centre) {
    std::copy(revolute.begin(), revolute.begin() + dof, revolute_.begin());
  }

  /// Takes the rows of all solutions that have one inside.
  void take(const Solutions<dof, capacity>& found) {
    double squares[capacity];
    rows_.truncate(inverse::keep_within(found, within(), rows_.begin(), squares));
    bool is_marked = false;
    for (const Solution<dof>& row : rows_) is_marked = is_marked || row.continuum;
    effort = found.effort;
    status = inverse::status_within(found.status, empty(), is_marked);
  }
  /// For generated code: room for rows that stand next to the centre, which `count` then are.
  [[nodiscard]] Solutions<dof, capacity>& room() { return rows_; }
  void take_rows(int count) {
    rows_.truncate(count);
    status = count == 0 ? Status::unreachable : Status::solved;
  }
  [[nodiscard]] const Joints<dof>& centre() const { return centre_; }
  [[nodiscard]] inverse::Within<dof> within() const {
    return inverse::Within<dof>(limits_.limits(), revolute_, centre_);
  }

 private:
  /// All representatives of a joint and of those in front of it, which change faster.
  template <int joint, class Visit>
  static void turns_of(const Turns& turns, Solution<dof>& row, const Visit& visit) {
    if constexpr (joint < 0) {
      visit(static_cast<const Solution<dof>&>(row));
    } else if (joint >= turns.last) {
      turns_of<joint - 1>(turns, row, visit);
    } else {
      const int count = turns.count[joint];
      for (int index = 0; index < count; ++index) {
        row.q[joint] = turns.values[joint][index];
        turns_of<joint - 1>(turns, row, visit);
      }
    }
  }

  inverse::TurnLimits<dof> limits_;
  JointKinds<dof> revolute_;
  Joints<dof> centre_;
  Solutions<dof, capacity> rows_;
};

}  // namespace qvgen
