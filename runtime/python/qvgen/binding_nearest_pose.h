// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/nearest_pose.h>

#include "binding_inverse.h"

/// The nearest reachable pose for Python: rows of poses in, rows padded to equal size out.
namespace qvgen::python {

inline Prefer prefer_of(const std::string& name) {
  if (name == "both") return Prefer::both;
  if (name == "position") return Prefer::position;
  if (name == "orientation") return Prefer::orientation;
  throw py::value_error("prefer: neither \"both\", nor \"position\", nor \"orientation\"");
}

/// Returns qvgen.NearestRows of every pose: NaN and False behind the last row of each.
template <int dof, class Solver>
py::object nearest_rows(const py::object& pose, const py::object& seed,
                        const NearestPoseOptions<dof>& options, const Solver& solver) {
  constexpr int most = NearestRows<dof>::max_size;
  std::vector<Rows<double>> arguments{Rows<double>(pose, {7}, "pose")};
  if (!seed.is_none()) arguments.emplace_back(seed, Shape{dof}, "seed");
  const py::ssize_t batch = batch_of(arguments);
  const py::object none = py::none();
  auto joints = result_array<double>(none, batch, {most, dof});
  auto positions = result_array<double>(none, batch, {most});
  auto orientations = result_array<double>(none, batch, {most});
  auto continua = result_array<bool>(none, batch, {most});
  auto counts = result_array<int>(none, batch, {});
  auto status = result_array<int>(none, batch, {});
  double* q = joints.mutable_data();
  double* position = positions.mutable_data();
  double* orientation = orientations.mutable_data();
  bool* continuum = continua.mutable_data();
  int* count = counts.mutable_data();
  int* outcome = status.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::fill(q, q + joints.size(), nan);
    std::fill(position, position + positions.size(), nan);
    std::fill(orientation, orientation + orientations.size(), nan);
    std::fill(continuum, continuum + continua.size(), false);
    for_each_row(arguments, batch, [&](py::ssize_t i, const double* const* row) {
      const Pose<double> target = TargetOf<Pose<double>>::read(row[0]);
      const auto found =
          arguments.size() > 1
              ? solver.rows(target, options, std::array{Joints<dof>(vector<Joints<dof>>(row[1]))})
              : solver.rows(target, options);
      count[i] = found.size();
      outcome[i] = static_cast<int>(found.status);
      for (int k = 0; k < found.size(); ++k) {
        const py::ssize_t at = i * most + k;
        write(found[k].q, q + at * dof);
        position[at] = found[k].position_error;
        orientation[at] = found[k].orientation_error;
        continuum[at] = found[k].continuum;
      }
    });
  }
  return py::module_::import("qvgen").attr("NearestRows")(joints, positions, orientations, continua, counts,
                                                          status);
}

}  // namespace qvgen::python
