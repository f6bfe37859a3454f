// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <qvgen/floating_base.h>

/// Shared part of the Python modules of all robots: arrays in, one row or a batch of rows, arrays out.
namespace qvgen::python {

namespace py = pybind11;
template <class Scalar>
using Array = py::array_t<Scalar, py::array::c_style | py::array::forcecast>;
using Shape = std::vector<py::ssize_t>;

/// A docstring as pybind11 takes it for all lengths alike: with lambdas as plain pointers, a function of
/// Python for every list of arguments is compiled, and not one for every function.
inline const char* text(const char* docstring) { return docstring; }

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

inline Shape shape_of(const py::array& array) { return Shape(array.shape(), array.shape() + array.ndim()); }

template <class Scalar>
const char* name_of_type() {
  return sizeof(Scalar) == sizeof(float) ? "float32" : "float64";
}

/// compute(Scalar()) in float if all arguments are arrays of float32, else in double.
template <class Compute>
py::object in_scalar_of(std::initializer_list<py::handle> arguments, const Compute& compute) {
  const bool single = std::all_of(arguments.begin(), arguments.end(), [](const py::handle& argument) {
    return py::isinstance<py::array_t<float>>(argument);
  });
  return single ? compute(float()) : compute(double());
}

/// An argument: one row of a shape, or a batch of them.
template <class Scalar>
class Rows {
 public:
  Rows(const py::object& given, const Shape& shape, const char* name)
      : array_(Array<Scalar>::ensure(given)), step_(size_of(shape)) {
    if (!array_) {
      PyErr_Clear();
      throw py::type_error(std::string(name) + ": not an array of numbers");
    }
    const Shape found = shape_of(array_);
    const bool batch = found.size() == shape.size() + 1;
    if (Shape(found.begin() + (batch ? 1 : 0), found.end()) != shape)
      throw py::value_error(std::string(name) + " has the shape " + text_of(found) + "; it must be " +
                            text_of(shape) + ", or have a batch axis before that");
    if (batch) count_ = found.front();
    data_ = array_.data();
  }
  /// -1 for a single row.
  [[nodiscard]] py::ssize_t count() const { return count_; }
  [[nodiscard]] const Scalar* operator[](py::ssize_t row) const {
    return data_ + (count_ < 0 ? 0 : row * step_);
  }

 private:
  Array<Scalar> array_;
  const Scalar* data_ = nullptr;
  py::ssize_t step_;
  py::ssize_t count_ = -1;
};

/// The number of rows of a call; -1 if every argument is a single one.
template <class Scalar>
py::ssize_t batch_of(const std::vector<Rows<Scalar>>& arguments) {
  py::ssize_t batch = -1;
  for (const Rows<Scalar>& rows : arguments) {
    if (rows.count() < 0) continue;
    if (batch >= 0 && batch != rows.count())
      throw py::value_error("batches of " + std::to_string(batch) + " and of " +
                            std::to_string(rows.count()) + " rows");
    batch = rows.count();
  }
  return batch;
}

/// Returns the result's array: `out` if it is given and fits, else a new array.
template <class Number>
py::array_t<Number> result_array(const py::object& out, py::ssize_t batch, Shape shape) {
  if (batch >= 0) shape.insert(shape.begin(), batch);
  if (out.is_none()) return py::array_t<Number>(shape);
  if (!py::isinstance<py::array_t<Number>>(out))
    throw py::type_error(std::string("out: not an array of ") + name_of_type<Number>());
  const auto array = py::reinterpret_borrow<py::array>(out);
  if (shape_of(array) != shape || !array.writeable() || (array.flags() & py::array::c_style) == 0)
    throw py::value_error("out must be a writeable, C-contiguous array of the shape " + text_of(shape));
  return py::reinterpret_borrow<py::array_t<Number>>(out);
}

/// One row of an argument.
template <class Vector>
Vector vector(const typename Vector::Scalar* row) {
  return Eigen::Map<const Vector>(row);
}

/// One row of configurations: the base's quaternion w x y z and its position, then the joints.
template <class Configuration, class Scalar>
Configuration configuration(const Scalar* row) {
  Configuration result;
  result.base = {Eigen::Quaternion<Scalar>(row[0], row[1], row[2], row[3]), {row[4], row[5], row[6]}};
  for (Eigen::Index i = 0; i < result.q.size(); ++i) result.q[i] = row[7 + i];
  return result;
}

/// A result, row by row.
template <class Derived>
void write(const Eigen::MatrixBase<Derived>& matrix, typename Derived::Scalar* to) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) *to++ = matrix(i, k);
}
inline void write(double number, double* to) { *to = number; }
inline void write(float number, float* to) { *to = number; }
template <class Scalar>
void write(const Eigen::Transform<Scalar, 3, Eigen::Isometry>& transform, Scalar* to) {
  write(transform.matrix(), to);
}
template <class Scalar>
void write(const Pose<Scalar>& pose, Scalar* to) {
  const auto& q = pose.orientation;
  const auto& p = pose.position;
  const Scalar numbers[7] = {q.w(), q.x(), q.y(), q.z(), p.x(), p.y(), p.z()};
  std::copy(numbers, numbers + 7, to);
}

template <class Scalar, int dof>
void write(const FloatingConfiguration<Scalar, dof>& at, Scalar* to) {
  write(at.base, to);
  write(at.q, to + 7);
}

template <class Scalar, std::size_t Count>
void write(const std::array<Eigen::Transform<Scalar, 3, Eigen::Isometry>, Count>& transforms, Scalar* to) {
  for (std::size_t i = 0; i < Count; ++i) write(transforms[i], to + 16 * i);
}

/// visit(i, rows) for every row of the arguments.
template <class Scalar, class Visit>
void for_each_row(const std::vector<Rows<Scalar>>& arguments, py::ssize_t batch, const Visit& visit) {
  std::vector<const Scalar*> rows(arguments.size());
  for (py::ssize_t i = 0; i < (batch < 0 ? 1 : batch); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = arguments[k][i];
    visit(i, rows.data());
  }
}

/// Refers to a function of a row that gives something to write. One type for all: the loops are compiled
/// once.
template <class Scalar>
class RowFunction {
 public:
  template <class Function>
  RowFunction(const Function& function)  // NOLINT(google-explicit-constructor): for lambdas in calls
      : function_(&function), call_([](const void* own, const Scalar* const* rows, Scalar* to) {
          write((*static_cast<const Function*>(own))(rows), to);
        }) {}
  void operator()(const Scalar* const* rows, Scalar* to) const { call_(function_, rows, to); }

 private:
  const void* function_;
  void (*call_)(const void*, const Scalar* const*, Scalar*);
};

/// function(rows) for every row, without the interpreter's lock.
template <class Scalar>
py::object each_row(const std::vector<Rows<Scalar>>& arguments, const Shape& shape, const py::object& out,
                    RowFunction<Scalar> function) {
  const py::ssize_t batch = batch_of(arguments);
  py::array_t<Scalar> result = result_array<Scalar>(out, batch, shape);
  Scalar* to = result.mutable_data();
  const py::ssize_t step = size_of(shape);
  {
    const py::gil_scoped_release unlocked;
    for_each_row(arguments, batch,
                 [&](py::ssize_t i, const Scalar* const* rows) { function(rows, to + i * step); });
  }
  return std::move(result);
}

/// A struct of constants from a dictionary of some of them; the description's values for the others.
template <class Constants, class Scalar = double, class Names>
Constants constants(const py::object& given, const Names& names, const char* what) {
  Constants values;
  if (given.is_none()) return values;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const auto name = key.template cast<std::string>();
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) throw py::value_error(std::string(what) + " has no " + name);
    const auto number = value.template cast<Scalar>();
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
