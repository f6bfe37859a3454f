// SPDX-License-Identifier: MIT
#include "value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <Eigen/Geometry>

#include "reference/linear_algebra.h"

namespace qvgen::test::sources {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Kind = Tree::Kind;

[[noreturn]] void meaningless(const std::string& what) { throw std::domain_error(what); }

const char* name_of(const Value& value) {
  static const char* const names[] = {"a number", "a vector", "a quaternion", "a pair", "a matrix"};
  return names[value.index()];
}

Value negative(const Value& value) {
  if (const double* x = std::get_if<double>(&value)) return -*x;
  if (const Vector3d* v = std::get_if<Vector3d>(&value)) return Vector3d(-*v);
  if (const MatrixXd* m = std::get_if<MatrixXd>(&value)) return MatrixXd(-*m);
  meaningless(std::string("the opposite of ") + name_of(value));
}

/// A column of three is a vector.
Value matrix_or_vector(const MatrixXd& matrix) {
  if (matrix.rows() == 3 && matrix.cols() == 1) return Vector3d(matrix);
  return matrix;
}

Value matrix_product(const MatrixXd& a, const MatrixXd& b) {
  if (a.cols() != b.rows()) meaningless("the product of matrices that do not fit");
  return matrix_or_vector(a * b);
}

Value plus_matrices(const MatrixXd& a, const MatrixXd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) meaningless("the sum of matrices of two sizes");
  return MatrixXd(a + b);
}

Value plus(const Value& a, const Value& b) {
  if (a.index() == 0 && b.index() == 0) return std::get<double>(a) + std::get<double>(b);
  if (a.index() == 1 && b.index() == 1) return Vector3d(std::get<Vector3d>(a) + std::get<Vector3d>(b));
  if (a.index() == 4 && b.index() == 4) return plus_matrices(std::get<MatrixXd>(a), std::get<MatrixXd>(b));
  meaningless(std::string("the sum of ") + name_of(a) + " and " + name_of(b));
}

struct Times {
  Value operator()(double a, double b) const { return a * b; }
  Value operator()(double a, const Vector3d& b) const { return Vector3d(a * b); }
  Value operator()(const Vector3d& a, double b) const { return Vector3d(a * b); }
  Value operator()(const Vector3d& a, const Vector3d& b) const { return a.dot(b); }
  Value operator()(const Quaternion& a, const Quaternion& b) const { return a * b; }
  Value operator()(const Quaternion& a, const Vector3d& b) const { return rotated(a, b); }
  Value operator()(const Pair& a, const Pair& b) const { return a * b; }
  Value operator()(const MatrixXd& a, const Vector3d& b) const { return matrix_product(a, b); }
  Value operator()(const MatrixXd& a, const MatrixXd& b) const { return matrix_product(a, b); }
  Value operator()(double a, const MatrixXd& b) const { return MatrixXd(a * b); }
  Value operator()(const MatrixXd& a, double b) const { return MatrixXd(b * a); }
  template <class A, class B>
  Value operator()(const A& a, const B& b) const {
    meaningless(std::string("the product of ") + name_of(a) + " and " + name_of(b));
  }
};

Value times(const Value& a, const Value& b) { return std::visit(Times(), a, b); }

double real(const Value& value) {
  if (const double* x = std::get_if<double>(&value)) return *x;
  meaningless(std::string("a number is needed, not ") + name_of(value));
}

Vector3d vector(const Value& value) {
  if (const Vector3d* v = std::get_if<Vector3d>(&value)) return *v;
  meaningless(std::string("a vector is needed, not ") + name_of(value));
}

Value bracket(const std::vector<Value>& items) {
  if (items.size() == 1) return items[0];
  if (items.size() == 3) return Vector3d(real(items[0]), real(items[1]), real(items[2]));
  if (items.size() != 2) meaningless("brackets around " + std::to_string(items.size()));
  const bool no_vector = items[1].index() == 0 && std::get<double>(items[1]) == 0;
  return Quaternion{real(items[0]), no_vector ? Vector3d(Vector3d::Zero()) : vector(items[1])};
}

Value matrix(const std::vector<int>& size, const std::vector<Value>& entries) {
  if (entries.size() == 1) return entries[0];
  MatrixXd result(size[0], size[1]);
  for (int i = 0; i < size[0]; ++i)
    for (int k = 0; k < size[1]; ++k) result(i, k) = real(entries[static_cast<std::size_t>(i * size[1] + k)]);
  return matrix_or_vector(result);
}

/// A row times a column is an inner product whether it says so or not.
Value transposed(const Value& value) {
  if (const MatrixXd* matrix = std::get_if<MatrixXd>(&value)) return MatrixXd(matrix->transpose());
  return value;
}

const MatrixXd& square(const Value& value) {
  const MatrixXd* matrix = std::get_if<MatrixXd>(&value);
  if (matrix == nullptr || matrix->rows() != matrix->cols()) meaningless("a square matrix is needed");
  return *matrix;
}

double norm(const Value& value) {
  if (const MatrixXd* matrix = std::get_if<MatrixXd>(&value)) return matrix->norm();
  if (const Vector3d* v = std::get_if<Vector3d>(&value)) return v->norm();
  return std::abs(real(value));
}

Value power(const Value& base, double exponent) {
  const bool inverted = exponent == -1;
  if (inverted && base.index() == 2) return inverse(std::get<Quaternion>(base));
  if (inverted && base.index() == 3) return inverse(std::get<Pair>(base));
  if (inverted && base.index() == 4) return MatrixXd(reference::inverse(square(base)));
  return std::pow(real(base), exponent);
}

Value function(const std::string& name, const std::vector<Value>& x) {
  if (name == "transpose") return transposed(x.at(0));
  if (name == "det") return reference::determinant(square(x.at(0)));
  if (name == "norm") return norm(x.at(0));
  const double first = real(x.at(0));
  // A root that is zero by identity must not fail over its rounding.
  if (name == "sqrt") return std::sqrt(first < 0 && first > -1e-9 ? 0 : first);
  if (name == "sin") return std::sin(first);
  if (name == "cos") return std::cos(first);
  if (name == "tan") return std::tan(first);
  if (name == "asin") return std::asin(first);
  if (name == "acos") return std::acos(first);
  // An arctangent of two arguments is that of both, whatever it is called.
  return x.size() == 1 ? std::atan(first) : std::atan2(first, real(x[1]));
}

Vector3d axis_of(const std::string& text) {
  Vector3d axis = Vector3d::Zero();
  axis[text.back() - 'x'] = text.find('-') == std::string::npos ? 1 : -1;
  return axis;
}

Value motion(const std::string& text, double amount) {
  const Vector3d axis = axis_of(text);
  if (text[0] == 'T') return Pair{{}, amount * axis};
  return Pair{{std::cos(amount / 2), std::sin(amount / 2) * axis}, Vector3d::Zero()};
}

/// s3, c3, hs3, hc3.
std::optional<double> short_sine(const std::string& name, const Known& known) {
  const std::size_t half = name[0] == 'h' ? 1 : 0;
  if (name.size() != half + 2 || (name[half] != 's' && name[half] != 'c')) return {};
  const auto angle = known.find("theta" + name.substr(half + 1));
  if (angle == known.end()) return {};
  const double x = real(angle->second) / (half == 1 ? 2 : 1);
  return name[half] == 's' ? std::sin(x) : std::cos(x);
}

Value named(const std::string& name, const Known& known) {
  if (const auto found = known.find(name); found != known.end()) return found->second;
  if (const auto sine = short_sine(name, known)) return *sine;
  meaningless(name + " is not a name of this arm");
}

double angle(const Tree& tree, const Known& known) {
  double sum = 0;
  for (const int joint : tree.joints)
    sum += (joint < 0 ? -1 : 1) * real(named("theta" + std::to_string(std::abs(joint)), known));
  return tree.value * sum;
}

/// Left to right, but q v q' is the product of three quaternions.
Value product(const std::vector<Value>& factors) {
  Value result = factors[0];
  for (std::size_t i = 1; i < factors.size(); ++i) {
    const bool sandwich = i + 1 < factors.size() && result.index() == 2 && factors[i].index() == 1 &&
                          factors[i + 1].index() == 2;
    if (!sandwich) {
      result = times(result, factors[i]);
      continue;
    }
    const Quaternion pure{0, vector(factors[i])};
    result = (std::get<Quaternion>(result) * pure * std::get<Quaternion>(factors[i + 1])).v;
    ++i;
  }
  return result;
}

}  // namespace

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
}

Quaternion inverse(const Quaternion& q) { return {q.s, -q.v}; }

Vector3d rotated(const Quaternion& q, const Vector3d& v) { return (q * Quaternion{0, v} * inverse(q)).v; }

Pair operator*(const Pair& a, const Pair& b) { return {a.q * b.q, rotated(a.q, b.p) + a.p}; }

Pair inverse(const Pair& pair) { return {inverse(pair.q), -rotated(inverse(pair.q), pair.p)}; }

Value value_of(const Tree& tree, const Known& known, double sign) {
  if (tree.kind == Kind::number) return tree.value;
  if (tree.kind == Kind::name) return named(tree.text, known);
  if (tree.kind == Kind::angle) return angle(tree, known);
  std::vector<Value> parts;
  for (const Tree& part : tree.parts) parts.push_back(value_of(part, known, sign));
  switch (tree.kind) {
    case Kind::function:
      return function(tree.text, parts);
    case Kind::sum: {
      Value sum = parts[0];
      for (std::size_t i = 1; i < parts.size(); ++i) sum = plus(sum, parts[i]);
      return sum;
    }
    case Kind::product:
      return product(parts);
    case Kind::quotient:
      return times(1 / real(parts[1]), parts[0]);
    case Kind::power:
      return power(parts[0], real(parts[1]));
    case Kind::negative:
      return negative(parts[0]);
    case Kind::either:
      return times(sign * tree.value, parts[0]);
    case Kind::cross:
      return Vector3d(vector(parts[0]).cross(vector(parts[1])));
    case Kind::dot:
      return times(parts[0], parts[1]);
    case Kind::vector:
      return parts.size() == 1 ? parts[0] : bracket(parts);
    case Kind::bracket:
      return bracket(parts);
    case Kind::pair: {
      const Quaternion* q = std::get_if<Quaternion>(&parts[0]);
      if (q == nullptr) meaningless("a pair without a quaternion");
      return Pair{*q, vector(parts[1])};
    }
    case Kind::matrix:
      return matrix(tree.joints, parts);
    case Kind::motion:
      return motion(tree.text, real(parts[0]));
    default:
      meaningless("an expression of another kind");
  }
}

namespace {

/// Infinity for what is not a number.
template <class Matrix>
double largest(const Matrix& difference) {
  return difference.hasNaN() ? std::numeric_limits<double>::infinity() : difference.cwiseAbs().maxCoeff();
}

double largest(double difference) {
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::abs(difference);
}

struct Distance {
  double operator()(double a, double b) const { return largest(a - b); }
  double operator()(const Vector3d& a, const Vector3d& b) const { return largest(a - b); }
  double operator()(const Quaternion& a, const Quaternion& b) const {
    const double plain = std::max(largest(a.s - b.s), largest(a.v - b.v));
    const double opposite = std::max(largest(a.s + b.s), largest(a.v + b.v));
    return std::min(plain, opposite);
  }
  double operator()(const Pair& a, const Pair& b) const {
    return std::max((*this)(a.q, b.q), (*this)(a.p, b.p));
  }
  double operator()(const MatrixXd& a, const MatrixXd& b) const {
    const bool fit = a.rows() == b.rows() && a.cols() == b.cols();
    return fit ? largest(a - b) : std::numeric_limits<double>::infinity();
  }
  template <class A, class B>
  double operator()(const A&, const B&) const {
    return std::numeric_limits<double>::infinity();
  }
};

}  // namespace

double distance(const Value& a, const Value& b) { return std::visit(Distance(), a, b); }

bool same(const Value& a, const Value& b) { return distance(a, b) < 1e-9; }

}  // namespace qvgen::test::sources
