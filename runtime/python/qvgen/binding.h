// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <qvgen/pose.h>

/// What the Python modules of all robots share: arrays in, one row or a batch of rows, arrays out.
namespace qvgen::python {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

inline std::string text_of(const Shape& shape) {
  std::string text;
  for (const py::ssize_t size : shape) text += (text.empty() ? "" : ", ") + std::to_string(size);
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

inline py::ssize_t size_of(const Shape& shape) {
  py::ssize_t size = 1;
  for (const py::ssize_t each : shape) size *= each;
  return size;
}

/// An argument: one row of a shape, or a batch of them.
class Rows {
 public:
  Rows(const py::object& given, const Shape& shape, const char* name)
      : array_(Array::ensure(given)), step_(size_of(shape)) {
    if (!array_) {
      PyErr_Clear();
      throw py::type_error(std::string(name) + ": not an array of numbers");
    }
    const Shape found(array_.shape(), array_.shape() + array_.ndim());
    const bool batch = found.size() == shape.size() + 1;
    if (Shape(found.begin() + (batch ? 1 : 0), found.end()) != shape)
      throw py::value_error(std::string(name) + " has the shape " + text_of(found) + "; it must be " +
                            text_of(shape) + ", or have a batch axis before that");
    if (batch) count_ = found.front();
    data_ = array_.data();
  }
  /// -1 for a single row.
  [[nodiscard]] py::ssize_t count() const { return count_; }
  [[nodiscard]] const double* operator[](py::ssize_t row) const {
    return data_ + (count_ < 0 ? 0 : row * step_);
  }

 private:
  Array array_;
  const double* data_ = nullptr;
  py::ssize_t step_;
  py::ssize_t count_ = -1;
};

/// The number of rows of a call; -1 if every argument is a single one.
inline py::ssize_t batch_of(const std::vector<Rows>& arguments) {
  py::ssize_t batch = -1;
  for (const Rows& rows : arguments) {
    if (rows.count() < 0) continue;
    if (batch >= 0 && batch != rows.count())
      throw py::value_error("batches of " + std::to_string(batch) + " and of " +
                            std::to_string(rows.count()) + " rows");
    batch = rows.count();
  }
  return batch;
}

/// What is returned: `out` if it is given and fits, else a new array.
template <class Number>
py::array_t<Number> result_array(const py::object& out, py::ssize_t batch, Shape shape) {
  if (batch >= 0) shape.insert(shape.begin(), batch);
  if (out.is_none()) return py::array_t<Number>(shape);
  if (!py::isinstance<py::array_t<Number>>(out)) throw py::type_error("out: not an array of float64");
  const auto array = py::reinterpret_borrow<py::array>(out);
  const bool fits = Shape(array.shape(), array.shape() + array.ndim()) == shape;
  if (!fits || !array.writeable() || (array.flags() & py::array::c_style) == 0)
    throw py::value_error("out must be a writeable, C-contiguous array of the shape " + text_of(shape));
  return py::reinterpret_borrow<py::array_t<Number>>(out);
}

/// One row of an argument.
template <class Vector>
Vector vector(const double* row) {
  return Eigen::Map<const Vector>(row);
}

/// A result, row by row.
template <class Derived>
void write(const Eigen::MatrixBase<Derived>& matrix, double* to) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) *to++ = matrix(i, k);
}
inline void write(double number, double* to) { *to = number; }
inline void write(const Eigen::Isometry3d& transform, double* to) { write(transform.matrix(), to); }
inline void write(const Pose<double>& pose, double* to) {
  const Eigen::Quaterniond& q = pose.orientation;
  const Eigen::Vector3d& p = pose.position;
  const double numbers[7] = {q.w(), q.x(), q.y(), q.z(), p.x(), p.y(), p.z()};
  std::copy(numbers, numbers + 7, to);
}

inline Pose<double> pose_of(const double* row) {
  return {Eigen::Quaterniond(row[0], row[1], row[2], row[3]), Eigen::Vector3d(row[4], row[5], row[6])};
}

/// visit(i, rows) for every row of the arguments.
template <class Visit>
void for_each_row(const std::vector<Rows>& arguments, py::ssize_t batch, const Visit& visit) {
  std::vector<const double*> rows(arguments.size());
  for (py::ssize_t i = 0; i < (batch < 0 ? 1 : batch); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = arguments[k][i];
    visit(i, rows.data());
  }
}

/// function(rows) for every row, without the interpreter's lock.
template <class Function>
py::object each_row(const std::vector<Rows>& arguments, const Shape& shape, const py::object& out,
                    const Function& function) {
  const py::ssize_t batch = batch_of(arguments);
  py::array_t<double> result = result_array<double>(out, batch, shape);
  double* to = result.mutable_data();
  const py::ssize_t step = size_of(shape);
  {
    const py::gil_scoped_release unlocked;
    for_each_row(arguments, batch,
                 [&](py::ssize_t i, const double* const* rows) { write(function(rows), to + i * step); });
  }
  return std::move(result);
}

/// The solutions of every pose: (solutions, counts, status, branches), NaN and -1 behind the last of a pose.
template <int capacity, class Function>
py::tuple each_solution(const std::vector<Rows>& arguments, int dof, const Function& function) {
  const py::ssize_t batch = batch_of(arguments);
  auto solutions = result_array<double>(py::none(), batch, {capacity, dof});
  auto branches = result_array<int>(py::none(), batch, {capacity});
  auto counts = result_array<int>(py::none(), batch, {});
  auto status = result_array<int>(py::none(), batch, {});
  double* q = solutions.mutable_data();
  int* branch = branches.mutable_data();
  int* count = counts.mutable_data();
  int* outcome = status.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    std::fill(q, q + solutions.size(), std::numeric_limits<double>::quiet_NaN());
    std::fill(branch, branch + branches.size(), -1);
    for_each_row(arguments, batch, [&](py::ssize_t i, const double* const* rows) {
      const auto found = function(rows);
      count[i] = found.size();
      outcome[i] = static_cast<int>(found.status);
      for (int k = 0; k < found.size(); ++k) {
        write(found[k].q, q + (i * capacity + k) * dof);
        branch[i * capacity + k] = found[k].branch;
      }
    });
  }
  return py::make_tuple(solutions, counts, status, branches);
}

/// A struct of constants from a dictionary of some of them; the description's values for the others.
template <class Constants, class Names>
Constants constants(const py::object& given, const Names& names, const char* what) {
  Constants values;
  if (given.is_none()) return values;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const auto name = key.template cast<std::string>();
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) throw py::value_error(std::string(what) + " has no " + name);
    const auto number = value.template cast<double>();
    const auto at = static_cast<std::size_t>(place - names.begin()) * sizeof number;
    std::memcpy(reinterpret_cast<char*>(&values) + at, &number, sizeof number);
  }
  return values;
}

template <class Constants, class Names>
py::dict defaults(const Names& names) {
  const Constants values;
  py::dict all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    double number = 0;
    std::memcpy(&number, reinterpret_cast<const char*>(&values) + i * sizeof number, sizeof number);
    all[names[i]] = number;
  }
  return all;
}

template <class Values>
py::list list_of(const Values& values) {
  py::list list;
  for (const auto& value : values) list.append(value);
  return list;
}

}  // namespace qvgen::python
