// SPDX-License-Identifier: MIT
#include "description/tree/principal.h"

#include "model/evaluate.h"

namespace qvgen::description::tree {
namespace {

using cln::cl_R;

// Each sweep squares what is left beside the diagonal: eight are enough for a hundred digits.
constexpr int most_sweeps = 30;

/// Turns columns p and q by the angle that makes entry (p, q) of the matrix vanish.
void turn(Matrix& matrix, Matrix& axes, std::size_t p, std::size_t q) {
  const cl_R off = matrix.at(p).at(q);
  const cl_R size = cln::abs(matrix.at(p).at(p)) + cln::abs(matrix.at(q).at(q));
  if (cln::zerop(off) || model::vanishes(off / (cln::zerop(size) ? cl_R(1) : size))) return;
  const auto format = cln::float_format(model::evaluation_digits);
  const cl_R ratio = cln::cl_float((matrix.at(q).at(q) - matrix.at(p).at(p)) / (2 * off), format);
  const cl_R sign = cln::minusp(ratio) ? -1 : 1;
  const cl_R tangent = sign / (cln::abs(ratio) + cln::sqrt(cln::square(ratio) + 1));
  const cl_R c = 1 / cln::sqrt(cln::square(tangent) + 1), s = tangent * c;
  const auto columns = [&](Matrix& m) {
    for (Vector& row : m) {
      const cl_R a = row.at(p), b = row.at(q);
      row.at(p) = c * a - s * b;
      row.at(q) = s * a + c * b;
    }
  };
  columns(matrix);
  for (std::size_t k = 0; k < 3; ++k) {  // and the rows
    const cl_R a = matrix.at(p).at(k), b = matrix.at(q).at(k);
    matrix.at(p).at(k) = c * a - s * b;
    matrix.at(q).at(k) = s * a + c * b;
  }
  columns(axes);
  matrix.at(p).at(q) = matrix.at(q).at(p) = 0;
}

bool is_diagonal(const Matrix& m) {
  return cln::zerop(m[0][1]) && cln::zerop(m[0][2]) && cln::zerop(m[1][2]);
}

}  // namespace

Principal principal(const Matrix& symmetric) {
  Matrix matrix = symmetric;
  Principal result{{0, 0, 0}, {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}};
  for (int sweep = 0; sweep < most_sweeps && !is_diagonal(matrix); ++sweep) {
    turn(matrix, result.axes, 0, 1);
    turn(matrix, result.axes, 0, 2);
    turn(matrix, result.axes, 1, 2);
  }
  for (std::size_t i = 0; i < 3; ++i) result.moments.at(i) = matrix.at(i).at(i);
  return result;
}

Matrix tensor(const Principal& p) {
  Matrix result{Vector{0, 0, 0}, Vector{0, 0, 0}, Vector{0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        result.at(i).at(j) = result.at(i).at(j) + p.axes.at(i).at(k) * p.moments.at(k) * p.axes.at(j).at(k);
  return result;
}

}  // namespace qvgen::description::tree
