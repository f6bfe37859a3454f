// SPDX-License-Identifier: MIT
#include "cover.h"

namespace qvgen::inverse::certified {
namespace {

const Interval whole_turn{0x1.921fb54442d18p+2, 0x1.921fb54442d19p+2};
constexpr double half_turn_and_more = 0x1.921fb54442d19p+1;

/// True if all of a box is in a region, or in one that is whole turns off.
bool is_in(const Box& box, const Region& region, int unknowns) {
  for (int k = 0; k < unknowns; ++k) {
    const double turns = std::round((region.centre[k] - box.angle[k].middle()) / whole_turn.lower);
    const Interval way = box.angle[k] + Interval(turns) * whole_turn - Interval(region.centre[k]);
    if (!(way.magnitude() <= region.radius)) return false;
  }
  return true;
}

int widest(const Box& box, int unknowns) {
  int widest = 0;
  for (int k = 1; k < unknowns; ++k)
    if (box.angle[k].width() > box.angle[widest].width()) widest = k;
  return widest;
}

/// Boxes that are still to be looked at: the other halves of what has been halved, so that there are few.
class Stack {
 public:
  [[nodiscard]] bool is_empty() const { return size_ == 0; }
  [[nodiscard]] bool takes_two() const { return size_ + 2 <= capacity; }
  void push(const Box& box) { boxes_[size_++] = box; }
  Box pop() { return boxes_[--size_]; }

 private:
  static constexpr int capacity = 256;
  Box boxes_[capacity];
  int size_ = 0;
};

class Cover {
 public:
  Cover(const Equations& equations, const Region* regions, int count)
      : equations_(equations), regions_(regions), count_(count), unknowns_(equations.unknowns()) {}

  [[nodiscard]] bool is_complete(int most, int& boxes) {
    stack_.push(all_angles(unknowns_));
    for (boxes = 0; !stack_.is_empty(); ++boxes) {
      if (boxes == most || !stack_.takes_two()) return false;
      Box box = stack_.pop();
      if (!is_done(box)) push_halves(box);
    }
    return true;
  }

  /// Adds to `left` what is left of a box.
  void cover(const Box& start, double narrowest, long most, long& boxes, std::vector<Box>& left) {
    stack_.push(start);
    for (; !stack_.is_empty(); ++boxes) {
      Box box = stack_.pop();
      if (boxes < most && is_done(box)) continue;
      if (boxes < most && stack_.takes_two() && width(box) > narrowest)
        push_halves(box);
      else
        left.push_back(box);
    }
  }

 private:
  /// Wider boxes are not narrowed: their derivatives say nothing.
  static constexpr double widest_to_narrow = 0.9;

  [[nodiscard]] bool is_done(Box& box) const {
    if (is_known(box) || equations_.exclude(box)) return true;
    for (double before = width(box); before < widest_to_narrow; before = width(box)) {
      if (!equations_.narrow(box) || is_known(box)) return true;
      if (width(box) > before / 2) break;
    }
    return false;
  }

  void push_halves(const Box& box) {
    const int k = widest(box, unknowns_);
    const double middle = box.angle[k].middle();
    Box upper = box, lower = box;
    upper.angle[k].lower = lower.angle[k].upper = middle;
    stack_.push(upper);
    stack_.push(lower);
  }

  [[nodiscard]] double width(const Box& box) const { return box.angle[widest(box, unknowns_)].width(); }
  [[nodiscard]] bool is_known(const Box& box) const {
    for (int i = 0; i < count_; ++i)
      if (is_in(box, regions_[i], unknowns_)) return true;
    return false;
  }

  const Equations& equations_;
  const Region* regions_;
  int count_, unknowns_;
  Stack stack_;
};

}  // namespace

Box all_angles(int unknowns) {
  Box all;
  for (int k = 0; k < unknowns; ++k) all.angle[k] = {-half_turn_and_more, half_turn_and_more};
  return all;
}

std::vector<Box> uncovered(const Equations& equations, const std::vector<Region>& regions,
                           const std::vector<Box>& start, double narrowest, long most, long& boxes) {
  std::vector<Box> left;
  Cover cover(equations, regions.data(), static_cast<int>(regions.size()));
  for (const Box& box : start) cover.cover(box, narrowest, most, boxes, left);
  return left;
}

bool is_covered(const Equations& equations, const Region* regions, int count, int most, int& boxes) {
  return Cover(equations, regions, count).is_complete(most, boxes);
}

}  // namespace qvgen::inverse::certified
