// SPDX-License-Identifier: MIT
#include "path/poses.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>

#include <fmt/format.h>
#include <qvgen/orientation.h>
#include <qvgen/pose.h>

namespace qvgen::path {
namespace {

using description::Diagnostic;
using measured::Quantity;
using measured::Table;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The notations of an orientation: names of the columns, all of which a file has, or none.
const std::array<std::vector<std::string>, 4> notations{
    {{"qw", "qx", "qy", "qz"}, {"roll", "pitch", "yaw"}, {"rx", "ry", "rz"}, {"ax", "ay", "az"}}};

std::vector<measured::Wanted> wanted() {
  std::vector<measured::Wanted> columns;
  const auto add = [&](const std::string& name, Quantity quantity, bool required,
                       std::vector<std::string> others) {
    columns.push_back({name, quantity, required, false, std::move(others)});
  };
  for (const char* name : {"x", "y", "z"}) add(name, Quantity::length, true, {});
  for (const std::string& name : notations[0]) add(name, Quantity::number, false, {});
  for (const std::string& name : notations[1]) add(name, Quantity::angle, false, {});
  for (const std::string& name : notations[2]) add(name, Quantity::angle, false, {});
  for (const std::string& name : notations[3]) add(name, Quantity::number, false, {});
  add("t", Quantity::time, false, {"time"});
  return columns;
}

Diagnostic note_of(const std::string& file, int line, Diagnostic::Severity severity, std::string message,
                   std::string hint = "") {
  Diagnostic note;
  note.severity = severity;
  note.file = file;
  note.line = line;
  note.message = std::move(message);
  note.hint = std::move(hint);
  return note;
}

/// Returns which notation the table has; -1 with a mistake if it has none, a part of one, or several.
int notation_of(const Table& table, std::vector<Diagnostic>& diagnostics) {
  int found = -1, partly = 0, whole = 0;
  for (std::size_t i = 0; i < notations.size(); ++i) {
    const auto has = std::count_if(notations[i].begin(), notations[i].end(),
                                   [&](const auto& name) { return table.find(name) != nullptr; });
    if (has == static_cast<long>(notations[i].size())) {
      found = static_cast<int>(i);
      ++whole;
    } else if (has > 0) {
      ++partly;
    }
  }
  if (whole == 1 && partly == 0) return found;
  diagnostics.push_back(
      note_of(table.file, 1, Diagnostic::error,
              whole > 1 ? "orientations stand there in several notations"
                        : "the poses have no orientation, or a part of one",
              "name columns qw, qx, qy, qz, or roll, pitch, yaw, or rx, ry, rz, or ax, ay, az"));
  return -1;
}

/// Returns the least turn that takes a unit vector upon another one, which is not opposite. Eigen's function
/// takes seconds to compile: it decomposes a matrix for opposite ones.
Quaternion<double> least_turn(const Vector3<double>& from, const Vector3<double>& to) {
  const double twice_cosine = std::sqrt(2 * (1 + from.dot(to)));  // of half the angle
  const Vector3<double> axis = from.cross(to) / twice_cosine;
  return {twice_cosine / 2, axis.x(), axis.y(), axis.z()};
}

/// Turns an orientation by the least angle so that the tool's z axis has a direction; that is half a turn
/// about x where it points the other way.
Quaternion<double> with_axis(const Quaternion<double>& from, const Vector3<double>& axis) {
  const Vector3<double> old = from * Vector3<double>(0, 0, 1), unit = axis.normalized();
  if (old.dot(unit) < -1 + 1e-12) return from * Quaternion<double>(0, 1, 0, 0);
  return (least_turn(old, unit) * from).normalized();
}

/// Returns the orientation of a row; where only an axis is given, the one next to that of the row before.
Quaternion<double> orientation_of(const Table& table, int notation, std::size_t row,
                                  const Quaternion<double>& before) {
  const auto& names = notations.at(static_cast<std::size_t>(notation));
  const auto value = [&](std::size_t i) { return (*table.find(names[i]))[row]; };
  if (notation == 0) return {value(0), value(1), value(2), value(3)};
  if (notation == 1) return from_euler_angles<double>({value(0), value(1), value(2)}, ros_rpy);
  const Vector3<double> vector(value(0), value(1), value(2));
  return notation == 2 ? from_rotation_vector<double>(vector) : with_axis(before, vector);
}

Quaternion<double> last_of(const Poses& poses) {
  if (poses.samples.empty()) return Quaternion<double>::Identity();
  const Sample& last = poses.samples.back();
  return {last.w, last.x, last.y, last.z};
}

/// A mistake if a row's axis has no direction.
void check_axis(const Table& table, std::size_t row, std::vector<Diagnostic>& diagnostics) {
  const double x = (*table.find("ax"))[row], y = (*table.find("ay"))[row], z = (*table.find("az"))[row];
  const double length = std::hypot(x, y, z);
  if (length > 1e-6 && length < 1e6) return;
  diagnostics.push_back(note_of(table.file, table.lines[row], Diagnostic::error,
                                fmt::format("the tool's axis has the length {:.6g}", length),
                                "ax, ay, az are the direction of the tool's z axis, of any length"));
}

Sample sample_of(const Table& table, int notation, std::size_t row, const std::string& file,
                 const Quaternion<double>& before, std::vector<Diagnostic>& diagnostics) {
  Sample sample;
  if (notation == 3) check_axis(table, row, diagnostics);
  const Quaternion<double> q = orientation_of(table, notation, row, before);
  const double norm = q.norm();
  if (!(std::abs(norm - 1) < 1e-3))
    diagnostics.push_back(note_of(file, table.lines[row], Diagnostic::error,
                                  fmt::format("the quaternion has the length {:.6g}", norm),
                                  "orientations are unit quaternions, scalar part first in qw"));
  sample.w = q.w() / norm;
  sample.x = q.x() / norm;
  sample.y = q.y() / norm;
  sample.z = q.z() / norm;
  for (std::size_t i = 0; i < 3; ++i)
    sample.position[i] = (*table.find(std::array<std::string, 3>{"x", "y", "z"}.at(i)))[row];
  const std::vector<double>* times = table.find("t");
  sample.time = times != nullptr ? (*times)[row] : std::numeric_limits<double>::quiet_NaN();
  return sample;
}

double distance(const Sample& a, const Sample& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                    a.position[2] - b.position[2]);
}

double angle(const Sample& a, const Sample& b) {
  return angular_distance<double>(Quaternion<double>(a.w, a.x, a.y, a.z),
                                  Quaternion<double>(b.w, b.x, b.y, b.z));
}

/// Numbers that mean millimetres as a rule are refused, if the header says nothing.
void check_units(const Table& table, Poses& poses) {
  constexpr double far = 50;
  const auto states = [&](const measured::Column& column) {
    return column.name == "x" && column.unit_stated;
  };
  if (std::any_of(table.columns.begin(), table.columns.end(), states)) return;
  for (std::size_t i = 0; i < poses.samples.size(); ++i) {
    const auto* p = poses.samples[i].position;
    if (!(std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) > far)) continue;
    poses.diagnostics.push_back(
        note_of(table.file, poses.lines[i], Diagnostic::error,
                fmt::format("a position of {:.6g} {:.6g} {:.6g} m", p[0], p[1], p[2]),
                "if these are millimetres, write x [mm], y [mm], z [mm] in the header, else x [m]"));
    return;
  }
}

/// Turns of half a revolution have two ways, and times must rise.
void check_order(const std::string& file, Poses& poses) {
  for (std::size_t i = 1; i < poses.samples.size(); ++i) {
    const Sample &before = poses.samples[i - 1], &here = poses.samples[i];
    if (poses.timed && !(here.time > before.time))
      poses.diagnostics.push_back(
          note_of(file, poses.lines[i], Diagnostic::error,
                  fmt::format("t = {:.9g} s is not behind t = {:.9g} s before", here.time, before.time),
                  "times rise from pose to pose"));
    if (angle(before, here) > 3.13)
      poses.diagnostics.push_back(note_of(file, poses.lines[i], Diagnostic::error,
                                          "the tool turns by half a revolution from the pose before",
                                          "a pose between the two says which way round"));
    if (poses.diagnostics.size() >= measured::most_mistakes) return;
  }
}

void warn(const std::string& file, Poses& poses) {
  const std::size_t count = poses.samples.size();
  if (count < 2) return;
  std::vector<double> steps(count - 1);
  for (std::size_t i = 1; i < count; ++i) steps[i - 1] = distance(poses.samples[i - 1], poses.samples[i]);
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  std::size_t equal = 0, first_equal = 0, jumps = 0, first_jump = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (steps[i - 1] == 0 && angle(poses.samples[i - 1], poses.samples[i]) == 0 && equal++ == 0)
      first_equal = i;
    if (steps[i - 1] > 20 * usual && steps[i - 1] > 0.02 && jumps++ == 0) first_jump = i;
  }
  const auto add = [&](std::size_t i, const std::string& text) {
    poses.diagnostics.push_back(note_of(file, poses.lines[i], Diagnostic::warning, text));
  };
  if (equal > 0)
    add(first_equal, fmt::format("the pose before once more{}",
                                 equal > 1 ? fmt::format("; {} such lines in all", equal) : ""));
  if (jumps > 0)
    add(first_jump, fmt::format("a step of {:.4g} m, where others take {:.4g} m: the tool goes there in a "
                                "straight line{}",
                                steps[first_jump - 1], usual,
                                jumps > 1 ? fmt::format("; {} such steps in all", jumps) : ""));
}

/// Times by the tool's speed; mistakes where the tool only turns.
void add_times(const std::string& file, double speed, Poses& poses) {
  double time = 0;
  for (std::size_t i = 0; i < poses.samples.size(); ++i) {
    const double way = i > 0 ? distance(poses.samples[i - 1], poses.samples[i]) : infinity;
    const bool turns = i > 0 && way == 0 && angle(poses.samples[i - 1], poses.samples[i]) > 0;
    if (turns) {
      poses.diagnostics.push_back(note_of(file, poses.lines[i], Diagnostic::error,
                                          "the tool turns on the spot, which --speed gives no time",
                                          "add a column t [s]"));
      return;
    }
    if (i > 0) time += way / speed;
    poses.samples[i].time = time;
  }
  poses.timed = true;
}

}  // namespace

bool Poses::good() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(),
                      [](const Diagnostic& each) { return each.severity == Diagnostic::error; });
}

double Poses::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) sum += distance(samples[i - 1], samples[i]);
  return sum;
}

Poses read_poses(std::istream& stream, const std::string& file, const PoseOptions& options) {
  measured::TableResult read = measured::read_table(stream, file, wanted(), options.units);
  Poses poses;
  poses.diagnostics = read.diagnostics;
  if (!read.good()) return poses;
  const Table& table = read.table;
  const int notation = notation_of(table, poses.diagnostics);
  if (notation < 0) return poses;
  poses.lines = table.lines;
  for (std::size_t row = 0; row < table.rows() && poses.diagnostics.size() < measured::most_mistakes; ++row)
    poses.samples.push_back(sample_of(table, notation, row, file, last_of(poses), poses.diagnostics));
  poses.timed = table.find("t") != nullptr;
  if (!poses.good()) return poses;
  check_units(table, poses);
  check_order(file, poses);
  if (poses.good() && !poses.timed && options.speed > 0) add_times(file, options.speed, poses);
  if (poses.good()) warn(file, poses);
  return poses;
}

Poses read_poses(const std::filesystem::path& path, const PoseOptions& options) {
  std::ifstream stream(path);
  if (!stream)
    throw std::runtime_error(
        path.string() + " cannot be read: " + std::generic_category().message(errno) +
        "; give a table with the header x, y, z, qw, qx, qy, qz and a row for each pose");
  return read_poses(stream, path.string(), options);
}

}  // namespace qvgen::path
