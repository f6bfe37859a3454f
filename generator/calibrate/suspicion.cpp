// SPDX-License-Identifier: MIT
#include "calibrate/suspicion.h"

#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "calibrate/align.h"

namespace qvgen::calibrate {
namespace {

struct Mistake {
  std::string hint;
  std::function<void(Measurement&)> undo;
};

/// A subset of the rows, which is enough to see what fits.
DataSet thinned(const DataSet& set) {
  constexpr std::size_t most = 60;
  DataSet result = set;
  result.rows.clear();
  const std::size_t step = 1 + set.rows.size() / most;
  for (std::size_t i = 0; i < set.rows.size(); i += step) result.rows.push_back(set.rows[i]);
  return result;
}

std::vector<std::size_t> frames_of(const Identifiable& can) {
  std::vector<std::size_t> frames;
  for (const std::size_t index : can.candidates)
    if (can.model.parameters[index].nuisance) frames.push_back(index);
  return frames;
}

double misfit(const Identifiable& can, const DataSet& set) {
  const Weighted data{&set, std::vector<double>(set.rows.size(), 1.0)};
  const State state = fit(can.model, data, first_state(can.model, can.setup, set), frames_of(can), 15);
  return size_of(can.model, data, state).position;
}

void scale_angles(const Identifiable& can, Measurement& row, double factor) {
  for (std::size_t i = 0; i < row.q.size(); ++i)
    if (can.model.geometry.turning[i]) row.q[i] *= factor;
}

void scale_lengths(Measurement& row, double factor) {
  row.pose.position = factor * row.pose.position;
  row.distance *= factor;
}

/// Moves the numbers of a row's quaternion by one place: w stood first where it was taken to be last, or the
/// other way round.
void roll_quaternion(Measurement& row, bool scalar_to_front) {
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      axes(j, i) = row.pose.axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const Eigen::Quaterniond read(axes);
  const Eigen::Quaterniond meant = scalar_to_front
                                       ? Eigen::Quaterniond(read.x(), read.y(), read.z(), read.w())
                                       : Eigen::Quaterniond(read.z(), read.w(), read.x(), read.y());
  const Eigen::Matrix3d other = meant.toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      row.pose.axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = other(j, i);
}

std::vector<Mistake> usual_mistakes(const Identifiable& can) {
  constexpr double degree = std::numbers::pi / 180;
  const std::size_t count = can.model.geometry.turning.size();
  std::vector<Mistake> all{
      {"the joint values seem to be degrees: write q1 [deg], ...",
       [&can](Measurement& row) { scale_angles(can, row, degree); }},
      {"the joint values seem to be radians, not degrees",
       [&can](Measurement& row) { scale_angles(can, row, 1 / degree); }},
      {"the lengths seem to be millimetres: write x [mm], ...",
       [](Measurement& row) { scale_lengths(row, 1e-3); }},
      {"the lengths seem to be metres, not millimetres", [](Measurement& row) { scale_lengths(row, 1e3); }},
      {"the poses seem to be the other way round: tracker in target; or --camera is missing or too much",
       [](Measurement& row) { row.pose = inverse(row.pose); }},
      {"the quaternions seem to have w first: write qw, qx, qy, qz",
       [](Measurement& row) { roll_quaternion(row, true); }},
      {"the quaternions seem to have w last: write qx, qy, qz, qw",
       [](Measurement& row) { roll_quaternion(row, false); }}};
  for (std::size_t i = 0; i < count; ++i)
    all.push_back({fmt::format("joint {} seems to have the other sign", i + 1),
                   [i](Measurement& row) { row.q[i] = -row.q[i]; }});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      all.push_back({fmt::format("columns q{} and q{} seem to be swapped", i + 1, j + 1),
                     [i, j](Measurement& row) { std::swap(row.q[i], row.q[j]); }});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      all.push_back({fmt::format("columns {} and {} seem to be swapped", "xyz"[i], "xyz"[j]),
                     [i, j](Measurement& row) { std::swap(row.pose.position[i], row.pose.position[j]); }});
  return all;
}

}  // namespace

std::string suspicion(const Identifiable& can, const DataSet& set, const State& start) {
  const double reach = reach_of(can.model.geometry);
  const Weighted data{&set, std::vector<double>(set.rows.size(), 1.0)};
  const double found = size_of(can.model, data, start).position;
  if (found < 0.05 * reach) return "";
  const DataSet few = thinned(set);
  for (const Mistake& mistake : usual_mistakes(can)) {
    DataSet other = few;
    for (Measurement& row : other.rows) mistake.undo(row);
    if (misfit(can, other) < 0.02 * reach) return mistake.hint;
  }
  return fmt::format("positions differ by {:.3g} m; check the arm, its zeros, units and the order of columns",
                     found);
}

}  // namespace qvgen::calibrate
