// SPDX-License-Identifier: MIT
#include "derive/jacobian/singularities.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <stdexcept>

#include "derive/jacobian/circle_polynomial.h"
#include "derive/jacobian/forms.h"
#include "derive/jacobian/wrist.h"
#include "model/followers.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

using Rows = std::vector<std::vector<ex>>;

/// Determinant by minors of the last rows; `limit` sees the factors of each product before it is taken,
/// `name` simplifies or names each minor.
template <class Limit, class Name>
ex determinant(const Rows& m, const Limit& limit, const Name& name) {
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
        const ex& minor = minors[columns ^ (1U << j)];
        limit(row[j], minor);
        sum += sign * row[j] * minor;
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

/// True if the rows are whole vectors: only then is their determinant the same in every frame.
bool is_independent_of_frame(const std::vector<int>& rows) {
  return rows.size() == 6 || rows == std::vector<int>{0, 1, 2} || rows == std::vector<int>{3, 4, 5};
}

/// The determinant of a square part as a polynomial, in the frame in which it is made of the fewest terms.
ex polynomial_determinant(CirclePolynomials& circles, const Linkage& linkage, const Square& square) {
  Program unused;
  const std::size_t frames = is_independent_of_frame(square.rows) ? Frames(unused, linkage).last() + 1 : 1;
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
  const auto limit = [](const ex& a, const ex& b) { CirclePolynomials::check_product(a, b); };
  return determinant(best, limit, [&](const ex& minor) { return circles.reduced(minor); });
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

bool of_last_three_joints(const ex& value, const Linkage& linkage) {
  return !value.has(linkage.variables[0]) && !value.has(linkage.variables[1]) &&
         !value.has(linkage.variables[2]);
}

/// Name of the linkage's tool point.
enum class Point { tool, wrist_centre, last_axis };
std::string name_of(Point point) {
  switch (point) {
    case Point::tool:
      return "the tool point";
    case Point::wrist_centre:
      return "the wrist centre";
    case Point::last_axis:
      return "the origin of the last axis";
  }
  return {};
}

/// Adds the factors of a square part's determinant; false if it vanishes everywhere.
bool add_factors(Singularities& result, const Linkage& linkage, const Square& square, Point point) {
  CirclePolynomials circles;
  const ex polynomial = polynomial_determinant(circles, linkage, square);
  if (polynomial.is_zero()) return false;
  const auto product = circles.factored(polynomial, linkage.variables);
  result.constant *= product.constant;
  SingularCauses causes(circles, linkage, name_of(point));
  for (const auto& factor : product.factors) {
    const bool wrist = linkage.variables.size() == 6 && of_last_three_joints(factor.value, linkage);
    const SingularCause cause = wrist ? causes.of_wrist(factor.value, point == Point::wrist_centre)
                                      : causes.of(factor.value, square.columns);
    result.factors.push_back({cause, factor.value, factor.multiplicity});
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

Singularities not_factored(const std::string& reason) {
  Singularities result;
  result.not_factored = reason;
  return result;
}

ex named_determinant(Program& program, const Columns& columns, const std::vector<int>& chosen) {
  Rows rows;
  for (const int row : chosen) {
    rows.emplace_back();
    for (const Twist& column : columns) rows.back().push_back(entry(column, row));
  }
  const auto no_limit = [](const ex&, const ex&) {};
  return determinant(rows, no_limit, [&](const ex& minor) { return program.let(minor); });
}

}  // namespace

namespace {

Singularities factored(const model::Robot& robot) {
  Singularities result;
  const Linkage arm = linkage(robot);
  const std::size_t dof = arm.variables.size();
  if (dof > 6) return not_factored("more than six joints: the Jacobian has no determinant");
  if (has_symbolic_twist(arm)) return not_factored("twists that are symbols or no right angles");
  const auto centred = dof == 6 ? at_wrist_centre(arm) : std::nullopt;
  if (centred) {
    result.rows = {0, 1, 2, 3, 4, 5};
    result.decoupled = true;
    if (!add_factors(result, *centred, {{0, 1, 2}, range(0, 3)}, Point::wrist_centre) ||
        !add_factors(result, *centred, {{3, 4, 5}, range(3, 6)}, Point::wrist_centre))
      return not_factored("it vanishes everywhere");
    return result;
  }
  const Linkage simplest = dof == 6 ? at_last_pivot(arm) : arm;
  for (const std::vector<int>& rows : row_choices(static_cast<int>(dof))) {
    result.rows = rows;
    if (add_factors(result, simplest, {rows, range(0, dof)}, dof == 6 ? Point::last_axis : Point::tool))
      return result;
    result.constant = 1;
  }
  return not_factored("it vanishes everywhere");
}

}  // namespace

Singularities singularities(const model::Robot& robot) {
  if (model::has_followers(robot))
    throw std::domain_error("a joint follows another: the factors of the determinant are not derived");
  try {
    return factored(robot);
  } catch (const TooManyTerms& error) {
    return not_factored(error.what());
  }
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
