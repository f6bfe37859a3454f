// SPDX-License-Identifier: MIT
#include "reduced.h"

#include <algorithm>

namespace qvgen::inverse::certified {
namespace {

constexpr int next(int joint) { return (joint + 1) % joints; }
constexpr int before(int joint) { return (joint + joints - 1) % joints; }

Vector unit_vector(std::size_t i) {
  Vector result{};
  result[i] = 1;
  return result;
}

/// A vector that is surely across a direction, and not short.
Vector across(const Vector& direction) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (direction[i].magnitude() < direction[least].magnitude()) least = i;
  return cross(direction, unit_vector(least));
}

/// D = tool goal^-1, which closes the loop behind the last joint, and back.
struct Closing {
  Matrix rotation, back;
  Vector place, back_place;

  explicit Closing(const Loop& loop) {
    rotation = loop.tool * transposed(loop.goal);
    back = transposed(rotation);
    place = difference(loop.place, rotation * loop.goal_place);
    back_place = negative(back * place);
  }
};

/// Way that lines are carried, and its start: at joint Y's own frame, or between two joints behind a cut.
class Way {
 public:
  Way(const Loop& loop, const Closing& closing) : loop_(loop), closing_(closing) {}

  /// Through the joints from below `from` down to above `to`, to the frame behind joint `to`.
  void down(int from, int to, Line& line, Side& side) const {
    for (int at = from;;) {
      if (at == 0) closing(closing_.rotation, closing_.place, line);
      at = before(at);
      if (at == to) break;
      through(at, false, line, side);
    }
    line.settle();
  }
  /// Carries a line the other way round, to the frame before joint `to`.
  void up(int from, int to, Line& line, Side& side) const {
    for (int at = from;;) {
      at = next(at);
      if (at == 0) closing(closing_.back, closing_.back_place, line);
      if (at == to) break;
      through(at, true, line, side);
    }
    line.settle();
  }
  /// From a cut behind joint `cut`.
  void down_from_cut(int cut, int to, Line& line, Side& side) const {
    through(cut, false, line, side);
    down(cut, to, line, side);
  }

 private:
  static void closing(const Matrix& rotation, const Vector& place, Line& line) {
    line.turn(rotation);
    line.move(place);
  }

  /// A slide on the way is one of those that are dropped: what is used is not changed by it.
  void through(int at, bool backwards, Line& line, Side& side) const {
    if (!loop_.revolute[at]) return;
    line.move(negative(loop_.point[at]));
    side.joint[line.angles()] = at;
    line.turn(loop_.turns[at], backwards);
    line.move(loop_.point[at]);
    side.angles = line.angles();
  }

  const Loop& loop_;
  const Closing& closing_;
};

class Reduction {
 public:
  explicit Reduction(const Loop& loop) : loop_(loop), closing_(loop), way_(loop, closing_) {}

  void drop_turns(int x) {
    const int y = (x + 3) % joints;
    const Vector z = loop_.axis[x];
    both_ways(
        y, x, loop_.point[y], loop_.axis[y],
        [&](Line& line, Side& side, int& n) {
          side.function[n++] = line.point_along(z);
          side.function[n++] = line.direction_along(z);
          side.function[n++] = line.point_square();
          side.function[n++] = line.point_times_direction();
          side.function[n++] = line.moment_along(z);
        },
        loop_.point[x]);
  }

  void drop_slide(int x) {
    const int y = (x + 3) % joints;
    const Vector first = across(loop_.axis[x]);
    const Vector second = cross(loop_.axis[x], first);
    both_ways(y, x, loop_.point[y], loop_.axis[y], [&](Line& line, Side& side, int& n) {
      add_direction(line, side, n);
      side.function[n++] = line.point_along(first);
      side.function[n++] = line.point_along(second);
    });
  }

  void drop_slides(int x, int y) {
    both_ways(y, x, {}, loop_.axis[y], [&](Line& line, Side& side, int& n) {
      add_direction(line, side, n);
      side.function[n++] = line.moment_along(loop_.axis[x]);
    });
    both_ways(y, x, {}, across(loop_.axis[y]), add_direction);
  }

  void drop_neighbours(int x) {
    const int y = next(x);
    const Vector second = y == 0 ? closing_.rotation * loop_.axis[y] : loop_.axis[y];
    const Vector normal = cross(loop_.axis[x], second);
    from_cut(next(next(y)), x, unit_vector(0), [&](Line& line, Side& side, int& n) {
      add_direction(line, side, n);
      side.function[n++] = line.point_along(normal);
    });
    from_cut(next(next(y)), x, unit_vector(1), add_direction);
  }

  /// The cut is behind the second turn after a slide.
  void drop_three_slides(int x) {
    int cut = x;
    for (int turns = 0; turns < 2;) {
      cut = next(cut);
      turns += loop_.revolute[cut] ? 1 : 0;
    }
    from_cut(cut, x, unit_vector(0), add_direction);
    from_cut(cut, x, unit_vector(1), add_direction);
  }

  [[nodiscard]] Reduced result() const {
    Reduced all = result_;
    for (int n = 0; n < all.functions; ++n) {
      double most = 1e-3;
      for (const Side& side : all.side)
        for (const Interval& coefficient : side.function[n]) most = std::max(most, coefficient.magnitude());
      all.unit[n] = most;
    }
    return all;
  }

 private:
  static void add_direction(Line& line, Side& side, int& n) {
    for (std::size_t i = 0; i < 3; ++i) side.function[n++] = line.direction(i);
  }

  template <class Take>
  void both_ways(int from, int to, const Vector& point, const Vector& direction, const Take& take,
                 const Vector& origin = {}) {
    Line down(point, direction), up(point, direction);
    way_.down(from, to, down, result_.side[0]);
    way_.up(from, to, up, result_.side[1]);
    taken(down, up, take, origin);
  }
  template <class Take>
  void from_cut(int cut, int to, const Vector& direction, const Take& take) {
    Line down({}, direction), up({}, direction);
    way_.down_from_cut(cut, to, down, result_.side[0]);
    way_.up(cut, to, up, result_.side[1]);
    taken(down, up, take, {});
  }
  template <class Take>
  void taken(Line& down, Line& up, const Take& take, const Vector& origin) {
    int n = result_.functions, same = result_.functions;
    down.move(negative(origin));
    up.move(negative(origin));
    down.settle();
    up.settle();
    take(down, result_.side[0], n);
    take(up, result_.side[1], same);
    result_.functions = n;
  }

  const Loop& loop_;
  Closing closing_;
  Way way_;
  Reduced result_;
};

}  // namespace

int choices(const Loop& loop) {
  const bool turns_only =
      std::all_of(loop.revolute, loop.revolute + joints, [](bool revolute) { return revolute; });
  return turns_only ? joints / 2 : 1;
}

Reduced reduced(const Loop& loop, int choice) {
  int slide[joints] = {}, slides = 0;
  for (int i = 0; i < joints; ++i)
    if (!loop.revolute[i]) slide[slides++] = i;
  Reduction reduction(loop);
  if (slides == 0) reduction.drop_turns(choice);
  if (slides == 1) reduction.drop_slide(slide[0]);
  if (slides == 2) {
    const int apart = slide[1] - slide[0];
    if (apart == 1)
      reduction.drop_neighbours(slide[0]);
    else if (apart == joints - 1)
      reduction.drop_neighbours(slide[1]);
    else
      reduction.drop_slides(slide[0], slide[1]);
  }
  if (slides == 3) reduction.drop_three_slides(slide[0]);
  return reduction.result();
}

}  // namespace qvgen::inverse::certified
