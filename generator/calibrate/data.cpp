// SPDX-License-Identifier: MIT
#include "calibrate/data.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "model/motor_ranges.h"

namespace qvgen::calibrate {
namespace {

using description::Diagnostic;
using measured::Quantity;
using measured::Wanted;

constexpr std::array position_names{"x", "y", "z"};
constexpr std::array quaternion_names{"qw", "qx", "qy", "qz"};
constexpr std::array euler_names{"roll", "pitch", "yaw"};
constexpr std::array vector_names{"rx", "ry", "rz"};

/// Farthest value of a joint (rad, m) that is no mistake of units; a motor goes farther by its gear.
constexpr double most_turned = 8 * std::numbers::pi, most_slid = 100;

/// A column with values of a joint or of a motor.
struct Variable {
  std::string name;
  bool turns;
  double most;
};

/// Reads one file: its columns, then what they mean.
class DataReader {
 public:
  DataReader(const std::filesystem::path& path, const model::Robot& robot, const DataOptions& options)
      : robot_(robot), options_(options) {
    measured::TableOptions table_options;
    table_options.angle_unit = options.angle_unit;
    table_options.length_unit = options.length_unit;
    table_options.ignored = options.ignored;
    wanted_ = wanted();
    measured::TableResult read = measured::read_table(path, wanted_, table_options);
    table_ = std::move(read.table);
    result_.diagnostics = std::move(read.diagnostics);
    result_.good = std::none_of(result_.diagnostics.begin(), result_.diagnostics.end(),
                                [](const auto& each) { return each.severity == Diagnostic::error; });
    result_.set.file = path.string();
  }

  DataResult read() {
    if (!result_.good || !find_kind()) return std::move(result_);
    for (std::size_t i = 0; i < table_.rows(); ++i) add_row(i);
    number(result_.set.targets, &Measurement::target, "target");
    number(result_.set.surfaces, &Measurement::surface, surface_column_);
    if (said_ > measured::most_mistakes)
      say(table_.lines.back(), fmt::format("and {} more mistakes of rows", said_ - measured::most_mistakes),
          "repair those above first");
    return std::move(result_);
  }

 private:
  std::vector<Wanted> wanted() {
    std::vector<Wanted> all;
    const std::vector<double> gears = model::greatest_gears(robot_);
    for (const model::Joint& joint : model::driven_joints(robot_)) {
      const std::string name = fmt::format("q{}", joints_.size() + 1);
      const bool turns = joint.type == model::JointType::revolute;
      all.push_back({name, turns ? Quantity::angle : Quantity::length, true, false, {joint.variable}});
      joints_.push_back({name, turns, gears[joints_.size()] * (turns ? most_turned : most_slid)});
    }
    const auto add = [&](const char* name, Quantity quantity) {
      all.push_back({name, quantity, false, false, {}});
    };
    for (const char* name : position_names) add(name, Quantity::length);
    for (const char* name : quaternion_names) add(name, Quantity::number);
    for (const char* name : euler_names) add(name, Quantity::angle);
    for (const char* name : vector_names) add(name, Quantity::angle);
    add("distance", Quantity::length);
    for (const char* name : {"target", "surface", "plane", "sphere"}) add(name, Quantity::number);
    add("sigma", Quantity::length);
    add("sigma_angle", Quantity::angle);
    return all;
  }

  void say(int line, std::string message, std::string hint) {
    result_.diagnostics.push_back(
        {result_.set.file, line, 1, Diagnostic::error, std::move(message), std::move(hint)});
    result_.good = false;
  }
  /// Says a mistake of a row unless there were many already.
  void say_of_row(int line, std::string message, std::string hint) {
    if (++said_ <= measured::most_mistakes) say(line, std::move(message), std::move(hint));
    result_.good = false;
  }

  template <std::size_t N>
  bool has(const std::array<const char*, N>& names) {
    const auto is_there = [&](const char* name) { return table_.find(name) != nullptr; };
    const auto count = std::count_if(names.begin(), names.end(), is_there);
    if (count == 0 || count == static_cast<std::ptrdiff_t>(N)) return count != 0;
    std::string missing;
    for (const char* name : names)
      if (!is_there(name)) missing += (missing.empty() ? "" : ", ") + std::string(name);
    say(1, fmt::format("the table has some of {}, not {}", fmt::join(names, ", "), missing),
        "add them, or leave all out");
    return false;
  }

  bool find_kind() {
    const bool position = has(position_names), quaternion = has(quaternion_names);
    const bool euler = has(euler_names), vector = has(vector_names);
    const bool plane = table_.find("plane") != nullptr, sphere = table_.find("sphere") != nullptr;
    const bool distance = table_.find("distance") != nullptr;
    if (!result_.good) return false;
    if (int{quaternion} + int{euler} + int{vector} > 1)
      say(1, "the table has orientations twice", "keep one of qw qx qy qz, roll pitch yaw and rx ry rz");
    else if (int{position} + int{plane} + int{sphere} + int{distance} != 1)
      say(1, "the table must have one kind of measurement",
          "add columns x, y, z (with qw, qx, qy, qz for poses), or distance, or plane, or sphere");
    else if ((quaternion || euler || vector) && !position)
      say(1, "the table has orientations without positions", "add columns x, y, z");
    else if (options_.camera && !(quaternion || euler || vector))
      say(1, "--camera is for poses", "add the board's orientation: qw, qx, qy, qz");
    if (!result_.good) return false;
    const bool oriented = quaternion || euler || vector;
    result_.set.data = plane             ? Data::plane
                       : sphere          ? Data::sphere
                       : distance        ? Data::distance
                       : !oriented       ? Data::position
                       : options_.camera ? Data::camera
                                         : Data::pose;
    surface_column_ = plane ? "plane" : sphere ? "sphere" : "surface";
    result_.set.sigma_known = options_.sigma > 0 || table_.find("sigma") != nullptr;
    return true;
  }

  [[nodiscard]] double value(const char* name, std::size_t row, double otherwise = 0) const {
    const auto* values = table_.find(name);
    return values == nullptr ? otherwise : (*values)[row];
  }

  void add_row(std::size_t row) {
    Measurement each;
    each.line = table_.lines[row];
    for (const Variable& variable : joints_) {
      each.q.push_back((*table_.find(variable.name))[row]);
      check_variable(each.line, variable, each.q.back());
    }
    each.pose = identity(1.0);
    for (std::size_t i = 0; i < 3; ++i) each.pose.position[i] = value(position_names.at(i), row);
    for (const double entry : each.pose.position)
      if (std::abs(entry) > 100)
        say_of_row(each.line, fmt::format("a position of {:.6g} m", entry),
                   "write x [mm], y [mm], z [mm] in the header for millimetres");
    each.distance = value("distance", row);
    if (each.distance < 0 || (result_.set.data == Data::distance && each.distance < 1e-9))
      say_of_row(each.line, fmt::format("a distance of {:.6g} m", each.distance), "distances are above 0");
    read_orientation(each, row);
    read_sigma(each, row);
    result_.set.rows.push_back(std::move(each));
  }

  void check_variable(int line, const Variable& variable, double value) {
    if (std::abs(value) <= variable.most) return;
    const std::string& name = variable.name;
    if (variable.turns)
      say_of_row(line, fmt::format("'{}' is {:.6g} rad", name, value),
                 fmt::format("write {} [deg] in the header for degrees", name));
    else
      say_of_row(line, fmt::format("'{}' is {:.6g} m", name, value),
                 fmt::format("write {} [mm] in the header for millimetres", name));
  }

  void read_orientation(Measurement& each, std::size_t row) {
    if (table_.find("qw") != nullptr) {
      std::array<double, 4> q{};
      for (std::size_t i = 0; i < 4; ++i) q.at(i) = value(quaternion_names.at(i), row);
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (std::abs(length - 1) > 1e-3)
        return say_of_row(each.line, fmt::format("the quaternion has length {:.4g}", length),
                          "it is a unit quaternion; are columns swapped?");
      turn_by(each.pose, {q[1] / length, q[2] / length, q[3] / length}, q[0] / length);
    } else if (table_.find("rx") != nullptr) {
      const Vec<double> r{value("rx", row), value("ry", row), value("rz", row)};
      const double angle = std::sqrt(dot(r, r));
      const double share = angle < 1e-12 ? 0.5 : std::sin(angle / 2) / angle;
      if (angle > 4 * std::numbers::pi)
        return say_of_row(each.line, fmt::format("a turn of {:.6g} rad", angle),
                          "write rx [deg], ry [deg], rz [deg] for degrees");
      turn_by(each.pose, share * r, std::cos(angle / 2));
    } else if (table_.find("roll") != nullptr) {
      constexpr std::array<std::size_t, 3> axes{2, 1, 0};
      const Vec<double> position = each.pose.position;
      Rigid<double> turned = identity(1.0);
      for (const std::size_t axis : axes) {
        const double angle = value(euler_names.at(axis), row);
        turned = turned * turn(identity(1.0).axes.at(axis), std::cos(angle), std::sin(angle), 1.0);
      }
      each.pose.axes = turned.axes;
      each.pose.position = position;
    }
  }

  /// Sets the rotation from a unit quaternion.
  static void turn_by(Rigid<double>& pose, const Vec<double>& v, double w) {
    for (std::size_t i = 0; i < 3; ++i) {
      Vec<double> unit{};
      unit.at(i) = 1;
      pose.axes.at(i) = unit + 2.0 * cross(v, cross(v, unit)) + (2 * w) * cross(v, unit);
    }
  }

  void read_sigma(Measurement& each, std::size_t row) {
    const double sigma = options_.sigma > 0 ? options_.sigma : usual_sigma;
    const double angle =
        options_.sigma_angle > 0 ? options_.sigma_angle : usual_sigma_angle / usual_sigma * sigma;
    each.sigma = value("sigma", row, sigma);
    each.sigma_angle = value("sigma_angle", row, angle);
    if (!(each.sigma > 0) || !(each.sigma_angle > 0))
      say_of_row(each.line, "a standard deviation that is not above 0",
                 "write the measurement's standard deviation");
  }

  /// Numbers targets or surfaces from 0, in the order of the file's own numbers.
  void number(std::vector<int>& names, std::size_t Measurement::*member, const std::string& column) {
    constexpr std::size_t most = 64;
    const auto* values = table_.find(column);
    std::vector<int> numbers;
    for (std::size_t i = 0; i < table_.rows(); ++i) {
      const double value = values == nullptr ? 1 : (*values)[i];
      if (value != std::floor(value) || std::abs(value) > 1e6) {
        say_of_row(table_.lines[i], fmt::format("'{}' is {:.6g}", column, value), "number them 1, 2, ...");
        return;
      }
      numbers.push_back(static_cast<int>(value));
    }
    names = numbers;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    if (names.size() > most)
      return say(1, fmt::format("{} different values of '{}'", names.size(), column),
                 fmt::format("at most {} can be fitted", most));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      result_.set.rows[i].*member =
          static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), numbers[i]) - names.begin());
  }

  const model::Robot& robot_;
  const DataOptions& options_;
  std::vector<Wanted> wanted_;
  std::vector<Variable> joints_;
  measured::Table table_;
  DataResult result_;
  std::string surface_column_;
  std::size_t said_ = 0;
};

}  // namespace

DataResult read_data(const std::filesystem::path& path, const model::Robot& robot,
                     const DataOptions& options) {
  return DataReader(path, robot, options).read();
}

}  // namespace qvgen::calibrate
