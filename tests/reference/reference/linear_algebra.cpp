// SPDX-License-Identifier: MIT
// Textbook methods in plain loops: reflections of Householder with columns exchanged for ranks, solutions and
// inverses, rotations of Jacobi from one side for singular values, elimination for determinants. Eigen has
// them all, but its templates take ten times as long to compile, and they are what the generator and the
// runtime compute with.
#include "reference/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

const double* column(const MatrixXd& m, Index k) { return m.data() + k * m.rows(); }
double* column(MatrixXd& m, Index k) { return m.data() + k * m.rows(); }

double dot(const double* a, const double* b, Index count) {
  double sum = 0;
  for (Index i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

/// a P = Q R: reflections take the columns of `a`, of which the longest rest comes next if they are
/// exchanged, to a triangle.
class Triangle {
 public:
  Triangle(const MatrixXd& a, bool exchanged)
      : r_(a),
        v_(MatrixXd::Zero(a.rows(), std::min(a.rows(), a.cols()))),
        order_(static_cast<std::size_t>(a.cols())) {
    std::iota(order_.begin(), order_.end(), Index(0));
    for (Index k = 0; k < v_.cols(); ++k) {
      if (exchanged) bring_longest(k);
      const Index rest = r_.rows() - k;
      double* v = column(v_, k) + k;
      std::copy_n(column(r_, k) + k, rest, v);
      const double length = std::sqrt(dot(v, v, rest));
      v[0] += v[0] < 0 ? -length : length;
      const double scale = std::sqrt(dot(v, v, rest));
      if (scale == 0) continue;
      for (Index i = 0; i < rest; ++i) v[i] /= scale;
      for (Index j = k; j < r_.cols(); ++j) reflect(k, column(r_, j));
    }
  }

  [[nodiscard]] const MatrixXd& r() const { return r_; }
  [[nodiscard]] Index rank(double share) const {
    Index k = 0;
    while (k < v_.cols() && std::abs(r_(k, k)) > share * std::abs(r_(0, 0))) ++k;
    return k;
  }
  /// Returns column k of Q, which is square.
  [[nodiscard]] VectorXd direction(Index k) const {
    VectorXd x = VectorXd::Unit(r_.rows(), k);
    turn(x);
    return x;
  }
  /// Returns the shortest x that makes |a x - b| least.
  [[nodiscard]] VectorXd solve(VectorXd b) const {
    if (std::isnan(largest(r_)))
      return VectorXd::Constant(r_.cols(), std::numeric_limits<double>::quiet_NaN());
    for (Index k = 0; k < v_.cols(); ++k) reflect(k, b.data());
    const Index count = rank(epsilon * static_cast<double>(v_.cols()));
    VectorXd x = VectorXd::Zero(r_.cols());
    if (count == r_.cols()) {
      for (Index i = count; i-- > 0;) {
        double sum = b[i];
        for (Index j = i + 1; j < count; ++j) sum -= r_(i, j) * x[j];
        x[i] = sum / r_(i, i);
      }
    } else if (count > 0) {  // any x that fulfils the first rows; the shortest is a sum of them
      MatrixXd rows(r_.cols(), count);
      for (Index i = 0; i < count; ++i)
        for (Index j = 0; j < r_.cols(); ++j) rows(j, i) = j < i ? 0 : r_(i, j);
      const Triangle of_rows(rows, false);
      for (Index i = 0; i < count; ++i)
        x[i] = (b[i] - dot(column(of_rows.r_, i), x.data(), i)) / of_rows.r_(i, i);
      of_rows.turn(x);
    }
    VectorXd result(x.size());
    for (Index i = 0; i < x.size(); ++i) result[order_[static_cast<std::size_t>(i)]] = x[i];
    return result;
  }

 private:
  void bring_longest(Index k) {
    Index longest = k;
    double most = -1;
    for (Index j = k; j < r_.cols(); ++j) {
      const double* rest = column(r_, j) + k;
      const double square = dot(rest, rest, r_.rows() - k);
      if (square > most) {
        most = square;
        longest = j;
      }
    }
    std::swap_ranges(column(r_, k), column(r_, k) + r_.rows(), column(r_, longest));
    std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(longest)]);
  }
  void reflect(Index k, double* x) const {
    const double* v = column(v_, k) + k;
    const double twice = 2 * dot(v, x + k, v_.rows() - k);
    for (Index i = k; i < v_.rows(); ++i) x[i] -= twice * v[i - k];
  }
  /// Multiplies by Q.
  void turn(VectorXd& x) const {
    for (Index k = v_.cols(); k-- > 0;) reflect(k, x.data());
  }

  MatrixXd r_, v_;  ///< of v a unit vector for each reflection, below zeros
  std::vector<Index> order_;
};

void rotate(double* a, double* b, Index count, double c, double s) {
  for (Index i = 0; i < count; ++i) {
    const double was = a[i];
    a[i] = c * was - s * b[i];
    b[i] = s * was + c * b[i];
  }
}

/// Makes the columns of w = m v orthogonal, longest first, by rotations of pairs; v stays orthogonal.
void make_orthogonal(MatrixXd& w, MatrixXd& v) {
  const double least = epsilon * epsilon * dot(w.data(), w.data(), w.size());  // columns that are rounding
  const double close = epsilon * static_cast<double>(w.rows() + 4);
  bool again = true;
  for (int sweep = 0; again && sweep < 60; ++sweep) {
    again = false;
    for (Index i = 0; i < w.cols(); ++i)
      for (Index j = i + 1; j < w.cols(); ++j) {
        double *a = column(w, i), *b = column(w, j);
        const double aa = dot(a, a, w.rows()), bb = dot(b, b, w.rows()), ab = dot(a, b, w.rows());
        const bool orthogonal = std::abs(ab) <= close * std::sqrt(aa * bb) || std::min(aa, bb) <= least;
        if (orthogonal && aa >= bb) continue;
        if (std::isnan(aa + bb + ab)) return;
        double c = 0, s = 1;  // exchanges them
        if (!orthogonal) {
          const double half = std::atan2(-2 * ab, aa - bb) / 2;  // turns most of both into the first
          c = std::cos(half);
          s = std::sin(half);
          again = true;
        }
        rotate(a, b, w.rows(), c, s);
        rotate(column(v, i), column(v, j), v.rows(), c, s);
      }
  }
}

MatrixXd transposed(const MatrixXd& m) {
  MatrixXd result(m.cols(), m.rows());
  for (Index i = 0; i < m.rows(); ++i)
    for (Index k = 0; k < m.cols(); ++k) result(k, i) = m(i, k);
  return result;
}

VectorXd lengths(const MatrixXd& m) {
  VectorXd result(m.cols());
  for (Index k = 0; k < m.cols(); ++k) result[k] = std::sqrt(dot(column(m, k), column(m, k), m.rows()));
  return result;
}

}  // namespace

SingularValues singular_values(const MatrixXd& m) {
  if (m.rows() < m.cols()) {
    SingularValues other = singular_values(transposed(m));
    other.u.swap(other.v);
    return other;
  }
  MatrixXd w = m, v = MatrixXd::Identity(m.cols(), m.cols()), u(m.rows(), m.rows());
  make_orthogonal(w, v);
  const Triangle basis(w, false);  // Q has the directions of the columns, and those across all of them
  for (Index k = 0; k < u.cols(); ++k) {
    u.col(k) = basis.direction(k);
    if (k < w.cols() && basis.r()(k, k) < 0) u.col(k) = -u.col(k);
  }
  return {lengths(w), u, v};
}

VectorXd spectrum(const MatrixXd& m) {
  MatrixXd w = m.rows() < m.cols() ? transposed(m) : m, v(0, w.cols());
  make_orthogonal(w, v);
  return lengths(w);
}

double smallest_singular_value(const MatrixXd& m) { return spectrum(m).minCoeff(); }

Index rank(const MatrixXd& m, double share) { return Triangle(m, true).rank(share); }

double determinant(const MatrixXd& m) {
  MatrixXd rest = m;
  double result = 1;
  for (Index k = 0; k < rest.cols(); ++k) {
    Index row = k;
    for (Index i = k + 1; i < rest.rows(); ++i)
      if (std::abs(rest(i, k)) > std::abs(rest(row, k))) row = i;
    result *= row == k ? rest(k, k) : -rest(row, k);
    if (result == 0) return 0;
    for (Index j = k; j < rest.cols(); ++j) std::swap(rest(k, j), rest(row, j));
    for (Index j = k + 1; j < rest.cols(); ++j)
      for (Index i = k + 1; i < rest.rows(); ++i) rest(i, j) -= rest(i, k) / rest(k, k) * rest(k, j);
  }
  return result;
}

MatrixXd inverse(const MatrixXd& m) {
  const Triangle triangle(m, true);
  MatrixXd result(m.cols(), m.rows());
  for (Index k = 0; k < m.rows(); ++k) result.col(k) = triangle.solve(VectorXd::Unit(m.rows(), k));
  return result;
}

VectorXd pivots(const MatrixXd& m) {
  MatrixXd rest = m;
  VectorXd result(m.rows());
  for (Index k = 0; k < rest.rows(); ++k) {
    Index largest = k;
    for (Index i = k + 1; i < rest.rows(); ++i)
      if (std::abs(rest(i, i)) > std::abs(rest(largest, largest))) largest = i;
    for (Index j = 0; j < rest.cols(); ++j) std::swap(rest(k, j), rest(largest, j));
    for (Index i = 0; i < rest.rows(); ++i) std::swap(rest(i, k), rest(i, largest));
    result[k] = rest(k, k);
    for (Index j = k + 1; rest(k, k) != 0 && j < rest.cols(); ++j)
      for (Index i = k + 1; i < rest.rows(); ++i) rest(i, j) -= rest(i, k) / rest(k, k) * rest(k, j);
  }
  return result;
}

MatrixXd product(const MatrixXd& a, const MatrixXd& b) {
  eigen_assert(a.cols() == b.rows());
  MatrixXd result = MatrixXd::Zero(a.rows(), b.cols());
  for (Index j = 0; j < b.cols(); ++j)
    for (Index k = 0; k < a.cols(); ++k) {
      const double factor = b(k, j);
      const double* from = column(a, k);
      double* to = column(result, j);
      for (Index i = 0; i < a.rows(); ++i) to[i] += factor * from[i];
    }
  return result;
}

double largest(const MatrixXd& m) {
  double result = 0;
  for (Index i = 0; i < m.size(); ++i) {
    const double size = std::abs(m.data()[i]);
    if (std::isnan(size)) return size;
    result = std::max(result, size);
  }
  return result;
}

VectorXd least_squares(const MatrixXd& a, const VectorXd& b) {
  eigen_assert(a.rows() == b.size());
  return Triangle(a, true).solve(b);
}

VectorXd solve_symmetric(const MatrixXd& a, const VectorXd& b) { return least_squares(a, b); }

}  // namespace reference
