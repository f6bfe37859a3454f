// SPDX-License-Identifier: MIT
#include "derive/jacobian/singularities.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

#include "derive/jacobian/circle_polynomial.h"
#include "derive/jacobian/forms.h"
#include "derive/jacobian/wrist.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

using Rows = std::vector<std::vector<ex>>;

/// Determinant by minors of the last rows; `name` simplifies or names each minor.
template <class Name>
ex determinant(const Rows& m, const Name& name) {
  const std::size_t n = m.size();
  std::map<unsigned, ex> minors{{0U, ex(1)}};
  for (std::size_t size = 1; size <= n; ++size) {
    std::map<unsigned, ex> larger;
    const std::vector<ex>& row = m[n - size];
    for (unsigned columns = 0; columns < (1U << n); ++columns) {
      if (std::popcount(columns) != static_cast<int>(size)) continue;
      ex sum = 0;
      int sign = 1;
      for (std::size_t j = 0; j < n; ++j) {
        if ((columns >> j & 1U) == 0) continue;
        sum += sign * row[j] * minors[columns ^ (1U << j)];
        sign = -sign;
      }
      larger[columns] = name(sum);
    }
    minors = std::move(larger);
  }
  return minors[(1U << n) - 1];
}

ex entry(const Twist& twist, int row) {
  const Vector& v = row < 3 ? twist.linear : twist.angular;
  return row % 3 == 0 ? v.x : (row % 3 == 1 ? v.y : v.z);
}

/// The columns written out in one frame of the linkage. The determinant is the same in all of them.
Columns columns_in(const Linkage& linkage, std::size_t frame) {
  Program program;
  Frames frames(program, linkage);
  for (const Frames::Column& column : frames.columns()) {
    const MovingTwist twist = frames.move(column.twist, column.frame, frame);
    for (int row = 0; row < 6; ++row)
      program.output("", entry({twist.linear.value, twist.angular.value}, row));
  }
  const auto outputs = program.expanded();
  Columns columns;
  for (std::size_t i = 0; i < outputs.size(); i += 6)
    columns.push_back({{outputs[i].value, outputs[i + 1].value, outputs[i + 2].value},
                       {outputs[i + 3].value, outputs[i + 4].value, outputs[i + 5].value}});
  return columns;
}

struct Square {
  std::vector<int> rows;
  std::vector<std::size_t> columns;
};

/// The determinant of a square part as a polynomial, in the frame in which it is made of the fewest terms.
ex polynomial_determinant(CirclePolynomials& circles, const Linkage& linkage, const Square& square) {
  Program unused;
  const std::size_t frames = Frames(unused, linkage).last() + 1;
  Rows best;
  std::size_t fewest = 0;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const Columns columns = columns_in(linkage, frame);
    Rows rows;
    std::size_t terms = 0;
    for (const int row : square.rows) {
      rows.emplace_back();
      for (const std::size_t column : square.columns) {
        rows.back().push_back(circles.polynomial(entry(columns[column], row)));
        terms += rows.back().back().nops() + (rows.back().back().is_zero() ? 0 : 1);
      }
    }
    if (best.empty() || terms < fewest) {
      best = rows;
      fewest = terms;
    }
  }
  return determinant(best, [&](const ex& minor) { return circles.reduced(minor); });
}

std::vector<std::size_t> range(std::size_t first, std::size_t last) {
  std::vector<std::size_t> result(last - first);
  std::iota(result.begin(), result.end(), first);
  return result;
}

bool has_symbolic_twist(const Linkage& linkage) {
  return std::any_of(linkage.pivots.begin(), linkage.pivots.end(),
                     [](const auto& pivot) { return pivot.joint < 0; });
}

std::vector<std::size_t> joints_in(const ex& value, const Linkage& linkage) {
  std::vector<std::size_t> joints;
  for (std::size_t i = 0; i < linkage.variables.size(); ++i)
    if (value.has(linkage.variables[i])) joints.push_back(i);
  return joints;
}

bool all_axes_parallel(const Linkage& linkage) {
  Program unused;
  return Frames(unused, linkage).last() <= 1;
}

bool slides(std::size_t joint, const Linkage& linkage) {
  return std::none_of(linkage.pivots.begin(), linkage.pivots.end(),
                      [&](const auto& pivot) { return pivot.joint == static_cast<int>(joint); });
}

/// What turns the last three joints of six is the wrist; what the second joint changes is the arm as a whole
/// against the first axis, the shoulder; what is left is how far the arm is stretched: the elbow, or, where a
/// single sliding joint has come to its zero, the inner boundary.
SingularFactor::Kind kind_of(const std::vector<std::size_t>& joints, const Linkage& linkage) {
  using Kind = SingularFactor::Kind;
  const std::size_t dof = linkage.variables.size();
  const auto all_from = [&](std::size_t first) {
    return std::all_of(joints.begin(), joints.end(), [&](std::size_t j) { return j >= first; });
  };
  if (joints.size() == 1 && slides(joints.front(), linkage)) return Kind::boundary;
  if (dof == 6 && all_from(3)) return Kind::wrist;
  if (dof < 3 || all_axes_parallel(linkage) || all_from(2)) return Kind::elbow;
  return Kind::shoulder;
}

/// Of the tool point; zero where the first joint slides.
ex squared_distance_from_first_axis(const Linkage& linkage) {
  if (slides(0, linkage)) return 0;
  const Vector v = columns_in(linkage, 0).front().linear;
  return dot(v, v);
}

/// Adds the factors of a square part's determinant; false if it vanishes everywhere.
bool add_factors(Singularities& result, const Linkage& linkage, const Square& square) {
  CirclePolynomials circles;
  const ex polynomial = polynomial_determinant(circles, linkage, square);
  if (polynomial.is_zero()) return false;
  const auto product = circles.factored(polynomial, linkage.variables);
  result.constant *= product.constant;
  const ex distance = squared_distance_from_first_axis(linkage);
  for (const auto& factor : product.factors) {
    const auto joints = joints_in(factor.value, linkage);
    auto kind = kind_of(joints, linkage);
    const bool on_axis = kind != SingularFactor::Kind::wrist && linkage.variables.size() > 2 &&
                         !distance.is_zero() && circles.divides(factor.value, distance);
    if (on_axis) kind = SingularFactor::Kind::shoulder;
    result.factors.push_back({kind, factor.value, factor.multiplicity, joints});
  }
  return true;
}

/// All choices of n of the six rows in lexicographic order.
std::vector<std::vector<int>> row_choices(int n) {
  std::vector<std::vector<int>> choices;
  for (unsigned mask = 0; mask < 64; ++mask) {
    if (std::popcount(mask) != n) continue;
    std::vector<int> rows;
    for (int row = 0; row < 6; ++row)
      if ((mask >> row & 1U) != 0) rows.push_back(row);
    choices.push_back(rows);
  }
  std::sort(choices.begin(), choices.end());
  return choices;
}

ex named_determinant(Program& program, const Columns& columns, const std::vector<int>& chosen) {
  Rows rows;
  for (const int row : chosen) {
    rows.emplace_back();
    for (const Twist& column : columns) rows.back().push_back(entry(column, row));
  }
  return determinant(rows, [&](const ex& minor) { return program.let(minor); });
}

}  // namespace

std::string to_string(SingularFactor::Kind kind) {
  switch (kind) {
    case SingularFactor::Kind::boundary:
      return "inner boundary";
    case SingularFactor::Kind::shoulder:
      return "shoulder";
    case SingularFactor::Kind::elbow:
      return "elbow";
    case SingularFactor::Kind::wrist:
      return "wrist";
  }
  return {};
}

Singularities singularities(const model::Robot& robot) {
  Singularities result;
  const Linkage arm = linkage(robot);
  const std::size_t dof = arm.variables.size();
  if (dof > 6 || has_symbolic_twist(arm)) return result;
  const auto centred = dof == 6 ? at_wrist_centre(arm) : std::nullopt;
  if (centred) {
    result.rows = {0, 1, 2, 3, 4, 5};
    result.decoupled = true;
    if (!add_factors(result, *centred, {{0, 1, 2}, range(0, 3)}) ||
        !add_factors(result, *centred, {{3, 4, 5}, range(3, 6)}))
      return {};
    return result;
  }
  const Linkage simplest = dof == 6 ? at_last_pivot(arm) : arm;
  for (const std::vector<int>& rows : row_choices(static_cast<int>(dof))) {
    result.rows = rows;
    if (add_factors(result, simplest, {rows, range(0, dof)})) return result;
  }
  return {};
}

Program determinant_definition(const model::Robot& robot, const std::vector<int>& rows) {
  Program program;
  program.output("determinant", named_determinant(program, plain_jacobian(robot, program).columns, rows));
  return program;
}

Program determinant_by_frames(const model::Robot& robot) {
  const Linkage arm = at_last_pivot(linkage(robot));
  Program program;
  Frames frames(program, arm);
  const std::size_t middle = frames.last() / 2;
  Columns columns;
  for (const Frames::Column& column : frames.columns()) {
    const MovingTwist twist = frames.move(column.twist, column.frame, middle);
    columns.push_back({twist.linear.value, twist.angular.value});
  }
  program.output("determinant", named_determinant(program, columns, {0, 1, 2, 3, 4, 5}));
  return program;
}

}  // namespace qvgen::derive
