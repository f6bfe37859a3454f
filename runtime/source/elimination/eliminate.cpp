// SPDX-License-Identifier: MIT
// The constants of an elimination, in numbers of 64 bits of mantissa where the machine has them.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "null_space.h"

namespace qvgen::inverse::elimination {
namespace {

using Long = long double;
using Line = Long[line_functions];

struct LongMotion {
  Long rotation[9];
  Long translation[3];
};

LongMotion inverse_of(const Motion& m) {
  LongMotion r;
  for (int i = 0; i < 3; ++i) {
    r.translation[i] = 0;
    for (int k = 0; k < 3; ++k) {
      r.rotation[3 * i + k] = m.rotation[3 * k + i];
      r.translation[i] -= Long(m.rotation[3 * k + i]) * m.translation[k];
    }
  }
  return r;
}

Motion inverse_motion(const Motion& m) {
  const LongMotion inverse = inverse_of(m);
  Motion r;
  for (int i = 0; i < 9; ++i) r.rotation[i] = static_cast<double>(inverse.rotation[i]);
  for (int i = 0; i < 3; ++i) r.translation[i] = static_cast<double>(inverse.translation[i]);
  return r;
}

/// The loop's joints and constants; the one that the pose closes stays open.
void set_loop(const Chain& chain, bool backwards, int shift, Elimination& e) {
  e.backwards = backwards;
  e.shift = shift;
  for (int i = 0; i < joints; ++i) {
    const int k = (i + shift) % joints;
    e.joint[i] = backwards ? joints - 1 - k : k;
    e.slide[i] = chain.slides[e.joint[i]];
    e.link[i] = Motion{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    if (k == joints - 1) continue;
    e.link[i] = backwards ? inverse_motion(chain.links[joints - 2 - k]) : chain.links[k];
    for (double& t : e.link[i].translation) t /= chain.size;
  }
}

/// How two axes that follow each other in the loop lie, and the displacement that makes them skew: a turn
/// about the common normal if they are parallel, a shift along it if they meet. In the second's frame.
///
/// The axis of a slide is a line at infinity, that of the planes across it. A turn's axis meets this line if
/// and only if it is at right angles to the slide: a turn about the common normal takes them apart. Beside an
/// axis along the slide nothing has to be done.
struct Displacement {
  bool skew;
  bool possible;
  Long turn[3] = {}, shift[3] = {};
};

Displacement displacement_of(const Elimination& e) {
  constexpr double none = 1e-8;
  const Motion& link = e.link[1];
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(link.rotation);
  const Eigen::Vector3d first = rotation.row(2), second(0, 0, 1);
  // From the second's frame to the first's origin.
  const Eigen::Vector3d away = -(rotation.transpose() * Eigen::Map<const Eigen::Vector3d>(link.translation));
  const Eigen::Vector3d normal = first.cross(second);
  const bool has_points = !e.slide[1] && !e.slide[2];
  Displacement d{};
  Eigen::Map<Eigen::Matrix<Long, 3, 1>> turn(d.turn), shift(d.shift);
  d.possible = true;
  if (!has_points) {
    d.skew = std::abs(first.dot(second)) > none;
    if (!d.skew) turn = normal.normalized().cast<Long>();
    return d;
  }
  if (normal.norm() <= none) {
    const Eigen::Vector3d across = away - away.dot(second) * second;
    d.possible = across.norm() > none;
    if (d.possible) turn = across.normalized().cast<Long>();
    return d;
  }
  d.skew = std::abs(away.dot(normal)) > none * normal.norm();
  if (!d.skew) shift = normal.normalized().cast<Long>();
  return d;
}

/// The derivative of a line's functions by the inverse of the displacement.
void displace(const Displacement& d, const Line& f, Line& result) {
  constexpr Long identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  Long back[3];
  for (int i = 0; i < 3; ++i) back[i] = -d.shift[i];
  Line there, here;
  move_line(identity, d.shift, f, there);
  move_line(identity, back, f, here);
  for (int k = 0; k < line_functions; ++k) result[k] = (here[k] - there[k]) / 2;
  for (const int block : {0, 3, 8, 11})
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result[block + i] -= d.turn[j] * f[block + k] - d.turn[k] * f[block + j];
    }
}

/// The nine functions of the pair's joints that a line carried by them consists of, and their derivative.
struct PairMatrix {
  Line value[9], derivative[9];
};

void inverse_modes(bool slide, const Line& f, Long (&m)[3][line_functions]) {
  if (slide)
    slide_modes(f, m);
  else
    turn_modes(f, m);
  const int odd = slide ? 1 : 2;
  for (Long& x : m[odd]) x = -x;
}

PairMatrix pair_matrix(const Elimination& e, const Displacement& d) {
  const LongMotion first = inverse_of(e.link[0]), second = inverse_of(e.link[1]);
  const Long direction[3] = {first.rotation[2], first.rotation[5], first.rotation[8]};
  Line line;
  line_values(first.translation, direction, line);
  Long modes[3][line_functions];
  inverse_modes(e.slide[1], line, modes);
  PairMatrix q;
  for (int m = 0; m < 3; ++m) {
    Line moved, changed;
    move_line(second.rotation, second.translation, modes[m], moved);
    if (!d.skew) displace(d, moved, changed);
    Long of_value[3][line_functions], of_derivative[3][line_functions];
    inverse_modes(e.slide[2], moved, of_value);
    if (!d.skew) inverse_modes(e.slide[2], changed, of_derivative);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < line_functions; ++i) {
        q.value[3 * m + k][i] = of_value[k][i];
        q.derivative[3 * m + k][i] = of_derivative[k][i];
      }
  }
  return q;
}

/// Reflects x in the plane across v, from number `first` on; twice_by_square: 2 / v.v.
template <int size>
void reflect_across(const Long (&v)[size], Long twice_by_square, int first, Long* x) {
  Long share = 0;
  for (int i = first; i < size; ++i) share += v[i] * x[i];
  share *= twice_by_square;
  for (int i = first; i < size; ++i) x[i] -= share * v[i];
}

/// Householder's triangular form of nine columns.
class Triangular {
 public:
  explicit Triangular(const Line (&columns)[9]) {
    for (int k = 0; k < 9; ++k)
      for (int i = 0; i < line_functions; ++i) column_[k][i] = columns[k][i];
    for (int k = 0; k < 9; ++k) {
      Long square = 0;
      for (int i = k; i < line_functions; ++i) {
        mirror_[k][i] = column_[k][i];
        square += column_[k][i] * column_[k][i];
      }
      const Long length = std::sqrt(square), head = std::abs(column_[k][k]);
      mirror_[k][k] += column_[k][k] < 0 ? -length : length;
      twice_by_square_[k] = 1 / (length * (length + head));
      for (int j = k; j < 9; ++j) reflect(k, column_[j]);
    }
  }
  [[nodiscard]] bool has_full_rank() const {
    for (int k = 0; k < 9; ++k)
      if (!(std::abs(column_[k][k]) > 1e-12L * std::abs(column_[0][0]))) return false;
    return true;
  }
  /// The k-th of six vectors at right angles to all columns, and to each other.
  void outside(int k, Line& result) const {
    for (Long& x : result) x = 0;
    result[9 + k] = 1;
    for (int j = 8; j >= 0; --j) reflect(j, result);
  }
  /// Computes the k-th row of the columns' pseudo-inverse, which gives a vector's share of the k-th column in
  /// the least-squares sense.
  void share_of(int k, Line& result) const {
    for (Long& x : result) x = 0;
    for (int i = k; i < 9; ++i) {
      Long sum = i == k ? 1 : 0;
      for (int j = k; j < i; ++j) sum -= column_[i][j] * result[j];
      result[i] = sum / column_[i][i];
    }
    for (int j = 8; j >= 0; --j) reflect(j, result);
  }

 private:
  void reflect(int k, Long* x) const { reflect_across(mirror_[k], twice_by_square_[k], k, x); }

  Line column_[9], mirror_[9];
  Long twice_by_square_[9];
};

/// Six equations in a line's functions.
struct Rows {
  Line row[6];
};

/// Orthogonal combinations of them, none of them without one of the others: which of the equations depend on
/// others is then no question of their order.
Rows mixed(const Rows& rows) {
  constexpr Long mirrors[2][6] = {{1, 0.8L, -1.3L, 0.6L, 1.1L, -0.7L}, {0.9L, -1.2L, 0.5L, 1.4L, -0.6L, 1}};
  Rows result = rows;
  for (int i = 0; i < line_functions; ++i) {
    Long column[6];
    for (int r = 0; r < 6; ++r) column[r] = rows.row[r][i];
    for (const auto& mirror : mirrors) {
      Long square = 0;
      for (const Long x : mirror) square += x * x;
      reflect_across(mirror, 2 / square, 0, column);
    }
    for (int r = 0; r < 6; ++r) result.row[r][i] = column[r];
  }
  return result;
}

Long dot(const Line& a, const Line& b) {
  Long sum = 0;
  for (int i = 0; i < line_functions; ++i) sum += a[i] * b[i];
  return sum;
}

/// Rows against a line's functions before C3' and joint 4' have moved it.
void set_table(const Elimination& e, const Rows& rows, double (&table)[18][15]) {
  LongMotion link;
  for (int i = 0; i < 9; ++i) link.rotation[i] = e.link[2].rotation[i];
  for (int i = 0; i < 3; ++i) link.translation[i] = e.link[2].translation[i];
  for (int k = 0; k < line_functions; ++k) {
    Line unit = {}, moved;
    unit[k] = 1;
    Long modes[3][line_functions];
    turn_modes(unit, modes);
    for (int m = 0; m < 3; ++m) {
      move_line(link.rotation, link.translation, modes[m], moved);
      for (int r = 0; r < 6; ++r) table[6 * m + r][k] = static_cast<double>(dot(rows.row[r], moved));
    }
  }
}

/// True if the six equations are dependent at an outer angle of no importance.
bool equations_repeat(const Elimination& e, const Chain& chain, const Goal& goal) {
  PoseSystem system;
  set_pose<2>(e, chain, goal, system);
  using T = Lanes<2>;
  Reflections<T> reflections;
  equations_at(system.equations, spread<T>(0.8), spread<T>(0.6), reflections.row);
  triangularise(reflections, 6);
  return std::abs(reflections.diagonal[5][0]) < 1e-9 * std::abs(reflections.diagonal[0][0]);
}

/// A pose that has nothing to do with the arm: what holds of it holds of all.
Goal any_goal(const Chain& chain) {
  Goal goal;
  const Eigen::Matrix3d r = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized().toRotationMatrix();
  for (int i = 0; i < 9; ++i) goal.rotation[i] = r(i / 3, i % 3);
  const double at[3] = {0.9, -0.6, 0.7};
  for (int i = 0; i < 3; ++i) goal.translation[i] = at[i] * chain.size;
  return goal;
}

void clear(double (&table)[18][15]) {
  for (auto& row : table)
    for (double& x : row) x = 0;
}

/// The equations times the pair's columns are zero: so is the derivative of that.
Rows derivative_of(const Rows& rows, const PairMatrix& q, const Triangular& triangular) {
  Rows change = {};
  for (int k = 0; k < 9; ++k) {
    Line share;
    triangular.share_of(k, share);
    for (int r = 0; r < 6; ++r) {
      const Long by = dot(rows.row[r], q.derivative[k]);
      for (int i = 0; i < line_functions; ++i) change.row[r][i] -= by * share[i];
    }
  }
  return change;
}

/// True if the three turns behind the outer joint make any orientation: neighbours' axes are not parallel,
/// unless only the pose says how they lie.
bool turns_serve(const Elimination& e) {
  SlideSystem constants;
  set_slides(e.slide, e.link, constants);
  int stretch = 0, of_the_pose = 0;
  for (int k = 0; k < joints; ++k) {
    if (k > 0 && !e.slide[from_outer[k]]) ++stretch;
    if (from_outer[k] == 5 - e.shift) of_the_pose = stretch;
  }
  constexpr double none = 1e-16;
  const auto across = [&](int i) { return 1 - constants.rotation[i][8] * constants.rotation[i][8]; };
  return (of_the_pose == 1 || across(1) > none) && (of_the_pose == 2 || across(2) > none);
}

bool eliminate_slides(Elimination& e) {
  e.pair = Pair::slides;
  clear(e.equations);
  clear(e.derived);
  for (auto& row : e.pair_values)
    for (double& x : row) x = 0;
  return !e.slide[3] && turns_serve(e);
}

}  // namespace

bool eliminate(const Chain& chain, bool backwards, int shift, Elimination& e) {
  set_loop(chain, backwards, shift, e);
  if (std::count(e.slide, e.slide + joints, true) == 2) return eliminate_slides(e);
  if (e.slide[0] || e.slide[3]) return false;
  const Displacement displacement = displacement_of(e);
  if (!displacement.possible) return false;
  const PairMatrix q = pair_matrix(e, displacement);
  const Triangular triangular(q.value);
  if (!triangular.has_full_rank()) return false;
  Rows rows;
  for (int r = 0; r < 6; ++r) triangular.outside(r, rows.row[r]);
  rows = mixed(rows);
  set_table(e, rows, e.equations);
  // cos and sin of 2' stand beside the constant of 3', and the other way round.
  constexpr int places[4] = {3, 6, 1, 2};
  for (int k = 0; k < 4; ++k) {
    Line share;
    triangular.share_of(places[k], share);
    for (int i = 0; i < line_functions; ++i) e.pair_values[k][i] = static_cast<double>(share[i]);
  }
  e.pair = Pair::skew;
  if (displacement.skew) {
    clear(e.derived);
    return true;
  }
  set_table(e, derivative_of(rows, q, triangular), e.derived);
  e.pair = equations_repeat(e, chain, any_goal(chain)) ? Pair::repeats : Pair::confuses;
  return true;
}

}  // namespace qvgen::inverse::elimination
