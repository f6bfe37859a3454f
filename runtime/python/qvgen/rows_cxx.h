// SPDX-License-Identifier: MIT
// Loops over rows for what a robot has in C++ only: inverse kinematics by elimination, the arm angle, the
// nearest pose, configurations of floating bases. _cxx_rows.py prints what calls these templates.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include <qvgen/floating_base.h>
#include <qvgen/inverse/arm_angle.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/motors.h>
#include <qvgen/inverse/nearest_pose.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/tasks.h>

#include "rows.h"

namespace qvgen::python {

template <class Scalar>
const Scalar* row(const qvgen_call* c, int which, std::ptrdiff_t k) {
  return static_cast<const Scalar*>(c->rows[which]) + k * c->steps[which];
}
template <class Number>
Number* result(const qvgen_call* c, int which, std::ptrdiff_t k, std::ptrdiff_t size = 1) {
  return static_cast<Number*>(c->results[which]) + k * size;
}

template <class Vector>
Vector vector(const typename Vector::Scalar* from) {
  return Eigen::Map<const Vector>(from);
}

/// Constants from the numbers of their fields; the description's if it gives no names to any.
template <class Constants, class Names>
Constants constants(const void* from, const Names& names) {
  Constants values;
  if constexpr (std::tuple_size_v < Names >> 0) std::memcpy(&values, from, sizeof values);
  return values;
}

template <int dof>
std::optional<JointLimits<dof>> limits(const qvgen_call* c) {
  if (c->lower == nullptr) return std::nullopt;
  return JointLimits<dof>{vector<Joints<dof>>(static_cast<const double*>(c->lower)),
                          vector<Joints<dof>>(static_cast<const double*>(c->upper))};
}

/// Reads a target from a row of numbers.
template <class Target>
struct TargetOf;
template <>
struct TargetOf<Vector3<double>> {
  static Vector3<double> read(const double* row) { return {row[0], row[1], row[2]}; }
};
template <>
struct TargetOf<Eigen::Quaternion<double>> {
  static Eigen::Quaternion<double> read(const double* row) { return {row[0], row[1], row[2], row[3]}; }
};
template <>
struct TargetOf<Direction<double>> {
  static Direction<double> read(const double* row) { return {{row[0], row[1], row[2]}}; }
};
template <>
struct TargetOf<PositionAndDirection<double>> {
  static PositionAndDirection<double> read(const double* row) {
    return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
  }
};
template <>
struct TargetOf<PositionAndYaw<double>> {
  static PositionAndYaw<double> read(const double* row) { return {{row[0], row[1], row[2]}, row[3]}; }
};
template <>
struct TargetOf<PositionAndPitch<double>> {
  static PositionAndPitch<double> read(const double* row) { return {{row[0], row[1], row[2]}, row[3]}; }
};
template <>
struct TargetOf<PositionAndInclination<double>> {
  static PositionAndInclination<double> read(const double* row) {
    return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
  }
};
template <>
struct TargetOf<Pose<double>> {
  static Pose<double> read(const double* row) {
    return {Eigen::Quaterniond(row[0], row[1], row[2], row[3]), Vector3<double>(row[4], row[5], row[6])};
  }
};

/// Writes the rows of a pose, for as many as there is room. Returns how many there are.
template <int dof, class Found>
std::size_t put(const qvgen_call* c, std::ptrdiff_t k, const Found& found) {
  const auto count = static_cast<std::size_t>(found.size());
  *result<int>(c, 3, k) = static_cast<int>(std::min<std::size_t>(count, std::numeric_limits<int>::max()));
  *result<int>(c, 4, k) = static_cast<int>(found.status);
  if (c->capacity == 0) return count;
  std::ptrdiff_t at = k * c->capacity;
  for (const auto& each : found) {
    std::copy(each.q.data(), each.q.data() + dof, result<double>(c, 0, at, dof));
    *result<int>(c, 1, at) = each.branch;
    *result<unsigned char>(c, 2, at) = each.continuum ? 1 : 0;
    ++at;
  }
  return count;
}

/// Solves every row by `solve(k, more...)`, more being a seed, limits, both or nothing. Returns the most rows
/// of one; for a capacity below zero it solves nothing and returns how many rows a target has at most without
/// limits.
template <int dof, class Solve>
std::ptrdiff_t all_rows(const qvgen_call* c, int seed_at, const Solve& solve) {
  if (c->capacity < 0) return std::decay_t<decltype(solve(0))>::max_size;
  std::size_t most = 0;
  const auto within = limits<dof>(c);
  for (std::ptrdiff_t k = 0; k < c->count; ++k) {
    const auto seed = [&] { return vector<Joints<dof>>(row<double>(c, seed_at, k)); };
    std::size_t count = 0;
    if (c->flags[0] != 0)
      count = within ? put<dof>(c, k, solve(k, seed(), *within)) : put<dof>(c, k, solve(k, seed()));
    else
      count = within ? put<dof>(c, k, solve(k, *within)) : put<dof>(c, k, solve(k));
    most = std::max(most, count);
  }
  return static_cast<std::ptrdiff_t>(std::min<std::size_t>(most, std::numeric_limits<std::ptrdiff_t>::max()));
}

/// Solves every row on the branch of a seed, by `solve(k, seed, [limits])`.
template <int dof, class Solve>
std::ptrdiff_t near_rows(const qvgen_call* c, int seed_at, const Solve& solve) {
  const auto within = limits<dof>(c);
  Joints<dof> before = Joints<dof>::Zero();
  if (c->flags[1] != 0) before = vector<Joints<dof>>(row<double>(c, seed_at, 0));
  for (std::ptrdiff_t k = 0; k < c->count; ++k) {
    const Joints<dof> seed = c->flags[1] != 0 ? before : vector<Joints<dof>>(row<double>(c, seed_at, k));
    const auto found = within ? solve(k, seed, *within) : solve(k, seed);
    *result<int>(c, 1, k) = static_cast<int>(found.status);
    if (found.empty()) continue;
    before = found[0].q;
    std::copy(before.data(), before.data() + dof, result<double>(c, 0, k, dof));
  }
  return 0;
}

inline ArmAngleReference reference(const qvgen_call* c) {
  return c->flags[1] != 0 ? ArmAngleReference::stereographic() : ArmAngleReference::conventional();
}

/// Solves for the nearest poses: flags[0], whether there are seeds; flags[1], what comes first; numbers,
/// metres per radian and starts.
template <int dof, class Solver>
std::ptrdiff_t nearest_rows(const qvgen_call* c, const Solver& solver) {
  constexpr int most = NearestRows<dof>::max_size;
  NearestPoseOptions<dof> options;
  options.prefer = static_cast<Prefer>(c->flags[1]);
  options.metres_per_radian = c->numbers[0];
  options.starts = static_cast<int>(c->numbers[1]);
  if (const auto bounds = limits<dof>(c)) options.limits = *bounds;
  for (std::ptrdiff_t k = 0; k < c->count; ++k) {
    const Pose<double> target = TargetOf<Pose<double>>::read(row<double>(c, 0, k));
    const auto found =
        c->flags[0] != 0
            ? solver.rows(target, options, std::array{Joints<dof>(vector<Joints<dof>>(row<double>(c, 1, k)))})
            : solver.rows(target, options);
    for (int n = 0; n < found.size(); ++n) {
      const std::ptrdiff_t at = k * most + n;
      std::copy(found[n].q.data(), found[n].q.data() + dof, result<double>(c, 0, at, dof));
      *result<double>(c, 1, at) = found[n].position_error;
      *result<double>(c, 2, at) = found[n].orientation_error;
      *result<unsigned char>(c, 3, at) = found[n].continuum ? 1 : 0;
    }
    *result<int>(c, 4, k) = found.size();
    *result<int>(c, 5, k) = static_cast<int>(found.status);
  }
  return 0;
}

/// One row of configurations: the base's quaternion w x y z and its position, then the joints.
template <class Configuration>
Configuration configuration(const double* from) {
  Configuration at;
  at.base = TargetOf<Pose<double>>::read(from);
  at.q = vector<decltype(at.q)>(from + 7);
  return at;
}
template <class Configuration>
void write(const Configuration& at, double* to) {
  const auto& r = at.base.orientation;
  const auto& p = at.base.position;
  const double base[7] = {r.w(), r.x(), r.y(), r.z(), p.x(), p.y(), p.z()};
  std::copy(base, base + 7, to);
  std::copy(at.q.data(), at.q.data() + at.q.size(), to + 7);
}

}  // namespace qvgen::python
