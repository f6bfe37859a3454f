// SPDX-License-Identifier: MIT
// Iterator over rows that are made when they are asked for: branch by branch, each with its representatives
// by whole turns. `Set` has `branches()` and `start(branch, turns)`, which returns the first row of a branch
// and makes `Set::Turns` ready; `turns.next(q)` puts the next representative in place of joints, if there is
// one.
#pragma once

#include <cstddef>
#include <iterator>

#include <qvgen/inverse/solutions.h>

namespace qvgen::inverse {

template <class Set>
class RowIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Solution<Set::dof>;
  using difference_type = std::ptrdiff_t;
  using pointer = const value_type*;
  using reference = const value_type&;

  RowIterator(const Set& all, int branch) : all_(&all), branch_(branch) { begin_branch(); }
  reference operator*() const { return row_; }
  pointer operator->() const { return &row_; }
  RowIterator& operator++() {
    ++number_;
    if (turns_.next(row_.q)) return *this;
    ++branch_;
    begin_branch();
    return *this;
  }
  RowIterator operator++(int) {
    const RowIterator before = *this;
    ++*this;
    return before;
  }
  [[nodiscard]] int branch() const { return branch_; }
  friend bool operator==(const RowIterator& a, const RowIterator& b) {
    return a.branch_ == b.branch_ && a.number_ == b.number_;
  }
  friend bool operator!=(const RowIterator& a, const RowIterator& b) { return !(a == b); }

 private:
  void begin_branch() {
    number_ = 0;
    if (branch_ < all_->branches()) row_ = all_->start(branch_, turns_);
  }

  const Set* all_;
  int branch_;
  std::size_t number_ = 0;  ///< of the row among its branch's
  typename Set::Turns turns_;
  value_type row_;
};

}  // namespace qvgen::inverse
