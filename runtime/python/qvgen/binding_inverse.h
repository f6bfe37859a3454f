// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include <qvgen/inverse/arm_angle.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/motors.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/tasks.h>

#include "binding.h"

/// Inverse kinematics for Python: rows of targets in, solutions padded to equal size out. Always in double.
namespace qvgen::python {

/// Reads a target from a row of numbers, and says how many numbers it takes.
template <class Target>
struct TargetOf;

template <>
struct TargetOf<Vector3<double>> {
  static constexpr int size = 3;
  static Vector3<double> read(const double* row) { return {row[0], row[1], row[2]}; }
};
template <>
struct TargetOf<Eigen::Quaternion<double>> {
  static constexpr int size = 4;
  static Eigen::Quaternion<double> read(const double* row) { return {row[0], row[1], row[2], row[3]}; }
};
template <>
struct TargetOf<Direction<double>> {
  static constexpr int size = 3;
  static Direction<double> read(const double* row) { return {{row[0], row[1], row[2]}}; }
};
template <>
struct TargetOf<PositionAndDirection<double>> {
  static constexpr int size = 6;
  static PositionAndDirection<double> read(const double* row) {
    return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
  }
};
template <>
struct TargetOf<PositionAndYaw<double>> {
  static constexpr int size = 4;
  static PositionAndYaw<double> read(const double* row) { return {{row[0], row[1], row[2]}, row[3]}; }
};
template <>
struct TargetOf<PositionAndPitch<double>> {
  static constexpr int size = 4;
  static PositionAndPitch<double> read(const double* row) { return {{row[0], row[1], row[2]}, row[3]}; }
};
template <>
struct TargetOf<Pose<double>> {
  static constexpr int size = 7;
  static Pose<double> read(const double* row) {
    return {Eigen::Quaterniond(row[0], row[1], row[2], row[3]), Vector3<double>(row[4], row[5], row[6])};
  }
};

/// The arguments of a call, of which seed and limits may be None, and `given` is there for arms with a joint
/// given.
struct InverseArguments {
  py::object target, given, seed, limits;
};

/// None: none; "description": its own; else a pair of rows.
template <class Limits, int dof>
std::optional<JointLimits<dof>> limits_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  if (py::isinstance<py::str>(given) && given.cast<std::string>() == "description") return Limits();
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given) || py::len(given) != 2)
    throw py::value_error("limits: neither None, nor \"description\", nor a pair (lower, upper)");
  const auto row = [&](int which, const char* name) {
    const Rows<double> rows(given[py::int_(which)], {dof}, name);
    if (rows.count() >= 0) throw py::value_error(std::string(name) + " are the same for all poses: one row");
    return vector<Joints<dof>>(rows[0]);
  };
  return JointLimits<dof>{row(0, "lower limits"), row(1, "upper limits")};
}

inline ArmAngleReference reference_of(const std::string& name) {
  if (name == "conventional") return ArmAngleReference::conventional();
  if (name == "stereographic") return ArmAngleReference::stereographic();
  throw py::value_error("reference: neither \"conventional\" nor \"stereographic\"");
}

/// The arrays of qvgen.Solutions: NaN, -1 and False behind the last solution of each row.
template <int dof>
class SolutionArrays {
 public:
  SolutionArrays(py::ssize_t batch, py::ssize_t capacity)
      : capacity_(capacity),
        solutions_(result_array<double>(py::none(), batch, {capacity, dof})),
        branches_(result_array<int>(py::none(), batch, {capacity})),
        continua_(result_array<bool>(py::none(), batch, {capacity})),
        q_(solutions_.mutable_data()),
        branch_(branches_.mutable_data()),
        continuum_(continua_.mutable_data()) {
    std::fill(q_, q_ + solutions_.size(), std::numeric_limits<double>::quiet_NaN());
    std::fill(branch_, branch_ + branches_.size(), -1);
    std::fill(continuum_, continuum_ + continua_.size(), false);
  }

  template <class Rows>
  void put(py::ssize_t i, const Rows& rows) {
    py::ssize_t at = i * capacity_;
    for (const auto& row : rows) {
      write(row.q, q_ + at * dof);
      branch_[at] = row.branch;
      continuum_[at++] = row.continuum;
    }
  }
  [[nodiscard]] py::object result(const py::object& counts, const py::object& status) const {
    return py::module_::import("qvgen").attr("Solutions")(solutions_, counts, status, branches_, continua_);
  }

 private:
  py::ssize_t capacity_;
  py::array_t<double> solutions_;
  py::array_t<int> branches_;
  py::array_t<bool> continua_;
  double* q_;
  int* branch_;
  bool* continuum_;
};

/// True if it is known how many solutions there are at most. Where whole turns make more of one it is not.
template <class Found>
struct CapacityOf {
  static constexpr bool is_fixed = true;
};
template <int dof, int capacity>
struct CapacityOf<AllWithinLimits<dof, capacity>> {
  static constexpr bool is_fixed = false;
};

template <class Map, int capacity>
struct CapacityOf<AllWithinMotors<Map, capacity>> {
  static constexpr bool is_fixed = false;
};

/// Refuses what no machine has room for: arrays of more than 4 GB.
inline void check_size(std::size_t most, std::size_t rows, int dof) {
  if (static_cast<double>(most) * static_cast<double>(rows) * dof > 5e8)
    throw py::value_error(
        "limits: a pose has " + std::to_string(most) +
        " solutions that differ by whole turns: narrow the limits, pass fewer poses at once, or a "
        "seed, for one solution of each branch");
}

/// qvgen.Solutions of every row.
template <int dof, class Function>
py::object each_solution(const std::vector<Rows<double>>& arguments, const Function& function) {
  using Found = decltype(function(std::declval<const double* const*>()));
  const py::ssize_t batch = batch_of(arguments);
  auto counts = result_array<int>(py::none(), batch, {});
  auto status = result_array<int>(py::none(), batch, {});
  int* count = counts.mutable_data();
  int* outcome = status.mutable_data();
  const auto solve_all = [&](const auto& take) {
    const py::gil_scoped_release unlocked;
    for_each_row(arguments, batch, [&](py::ssize_t i, const double* const* rows) {
      const Found found = function(rows);
      count[i] = static_cast<int>(std::min<std::size_t>(found.size(), std::numeric_limits<int>::max()));
      outcome[i] = static_cast<int>(found.status);
      take(i, found);
    });
  };
  if constexpr (CapacityOf<Found>::is_fixed) {
    SolutionArrays<dof> arrays(batch, Found::max_size);
    solve_all([&](py::ssize_t i, const Found& found) { arrays.put(i, found); });
    return arrays.result(counts, status);
  } else {
    // Once to count and once to write: less than keeping all of them.
    std::size_t most = 0, rows = 0;
    solve_all([&](py::ssize_t /*i*/, const Found& found) {
      most = std::max(most, static_cast<std::size_t>(found.size()));
      ++rows;
    });
    check_size(most, rows, dof);
    SolutionArrays<dof> arrays(batch, static_cast<py::ssize_t>(most));
    solve_all([&](py::ssize_t i, const Found& found) { arrays.put(i, found); });
    return arrays.result(counts, status);
  }
}

/// One number for one given joint, a vector for several.
inline Shape shape_of_given(int count) { return count == 1 ? Shape{} : Shape{count}; }

/// solve(target, given..., more...), with the given values from the second row.
template <int... index, class Solve, class Target, class... More>
auto with_given(std::integer_sequence<int, index...> /*count*/, const Solve& solve,
                [[maybe_unused]] const double* const* row, const Target& target, const More&... more) {
  return solve(target, row[1][index]..., more...);
}

/// solve(target, [given...,] [seed,] [limits,] geometry, tolerance) for every row of one kind of target.
template <class Target, int dof, int given_count, class Geometry, class Solve>
py::object solutions_of(const InverseArguments& arguments, const std::optional<JointLimits<dof>>& limits,
                        const Geometry& g, double tolerance, const char* name, const Solve& solve) {
  std::vector<Rows<double>> rows{Rows<double>(arguments.target, {TargetOf<Target>::size}, name)};
  if constexpr (given_count > 0) rows.emplace_back(arguments.given, shape_of_given(given_count), "given");
  const std::size_t last = rows.size();
  if (!arguments.seed.is_none()) rows.emplace_back(arguments.seed, Shape{dof}, "seed");
  const auto call = [&](const double* const* row, const auto&... more) {
    const Target target = TargetOf<Target>::read(row[0]);
    return with_given(std::make_integer_sequence<int, given_count>(), solve, row, target, more..., g,
                      tolerance);
  };
  const auto seed = [&](const double* const* row) { return vector<Joints<dof>>(row[last]); };
  if (arguments.seed.is_none()) {
    if (!limits) return each_solution<dof>(rows, [&](const double* const* row) { return call(row); });
    return each_solution<dof>(rows, [&](const double* const* row) { return call(row, *limits); });
  }
  if (!limits)
    return each_solution<dof>(rows, [&](const double* const* row) { return call(row, seed(row)); });
  return each_solution<dof>(rows, [&](const double* const* row) { return call(row, seed(row), *limits); });
}

/// True if the last axis of a target is as long as this kind's.
template <class Target>
bool is_of_kind(const py::object& target) {
  const auto array = Array<double>::ensure(target);
  if (!array) PyErr_Clear();
  return array && array.ndim() > 0 && array.shape(array.ndim() - 1) == TargetOf<Target>::size;
}

/// Binds a function that takes a pose, or less (`Reduced`), told apart by the length of their last axis.
template <class Reduced, int dof, int given_count, class Geometry, class Solve>
py::object solutions_of_either(const InverseArguments& arguments,
                               const std::optional<JointLimits<dof>>& limits, const Geometry& g,
                               double tolerance, const Solve& solve) {
  if (is_of_kind<Pose<double>>(arguments.target))
    return solutions_of<Pose<double>, dof, given_count>(arguments, limits, g, tolerance, "target", solve);
  return solutions_of<Reduced, dof, given_count>(arguments, limits, g, tolerance, "target", solve);
}

/// qvgen.NearSolution of every row of one kind of target. On a path the seed of a row is the last solution
/// before it.
template <class Target, int dof, int given_count, class Geometry, class Solve>
py::object near_solutions_of(const InverseArguments& arguments, bool path,
                             const std::optional<JointLimits<dof>>& limits, const Geometry& g,
                             double tolerance, const char* name, const Solve& solve) {
  std::vector<Rows<double>> rows{Rows<double>(arguments.target, {TargetOf<Target>::size}, name)};
  if constexpr (given_count > 0) rows.emplace_back(arguments.given, shape_of_given(given_count), "given");
  const std::size_t last = rows.size();
  rows.emplace_back(arguments.seed, Shape{dof}, "seed");
  if (path && rows[last].count() >= 0)
    throw py::value_error("on a path there is one seed, that of the first pose");
  const py::ssize_t batch = batch_of(rows);
  auto solutions = result_array<double>(py::none(), batch, {dof});
  auto status = result_array<int>(py::none(), batch, {});
  double* q = solutions.mutable_data();
  int* outcome = status.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    std::fill(q, q + solutions.size(), std::numeric_limits<double>::quiet_NaN());
    Joints<dof> before = Joints<dof>::Zero();
    if (path) before = vector<Joints<dof>>(rows[last][0]);
    for_each_row(rows, batch, [&](py::ssize_t i, const double* const* row) {
      const Target target = TargetOf<Target>::read(row[0]);
      const Joints<dof> seed = path ? before : vector<Joints<dof>>(row[last]);
      const auto call = [&](const auto&... more) {
        return with_given(std::make_integer_sequence<int, given_count>(), solve, row, target, seed, more...,
                          g, tolerance);
      };
      const auto found = limits ? call(*limits) : call();
      outcome[i] = static_cast<int>(found.status);
      if (found.empty()) return;
      before = found[0].q;
      write(found[0].q, q + i * dof);
    });
  }
  return py::module_::import("qvgen").attr("NearSolution")(solutions, status);
}

/// Binds the function next to a seed that takes a pose, or less (`Reduced`), told apart by the length of
/// their last axis.
template <class Reduced, int dof, int given_count, class Geometry, class Solve>
py::object near_solutions_of_either(const InverseArguments& arguments, bool path,
                                    const std::optional<JointLimits<dof>>& limits, const Geometry& g,
                                    double tolerance, const Solve& solve) {
  if (is_of_kind<Pose<double>>(arguments.target))
    return near_solutions_of<Pose<double>, dof, given_count>(arguments, path, limits, g, tolerance, "target",
                                                             solve);
  return near_solutions_of<Reduced, dof, given_count>(arguments, path, limits, g, tolerance, "target", solve);
}

}  // namespace qvgen::python
