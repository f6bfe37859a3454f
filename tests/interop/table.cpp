// SPDX-License-Identifier: MIT
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "arm.h"

namespace arms {
namespace {

using Eigen::Vector3d;
using Numbers = std::vector<double>;

Joint joint(char type, const Vector3d& axis, const Vector3d& xyz, const Vector3d& rpy = Vector3d::Zero()) {
  return {type == 'R', axis, xyz, rpy};
}

const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

/// The table of Denavit and Hartenberg, each joint turned by what the row before ends with.
Arm ur(const Numbers& n) {
  Arm arm;
  const double alpha[6] = {90, 0, 0, 90, -90, 0}, a[6] = {0, n[1], n[2], 0, 0, 0},
               d[6] = {n[0], 0, 0, n[3], n[4], n[5]};
  arm.joints.push_back(joint('R', z, Vector3d::Zero()));
  for (int i = 0; i < 5; ++i) arm.joints.push_back(joint('R', z, {a[i], 0, d[i]}, {alpha[i], 0, 0}));
  arm.tool_xyz = {a[5], 0, d[5]};
  return arm;
}

/// All frames parallel at zero.
Arm six(const Numbers& n, double sign) {
  Arm arm;
  arm.joints = {joint('R', sign * z, {0, 0, n[0]}), joint('R', y, {n[1], 0, 0}),
                joint('R', y, {0, 0, n[2]}),        joint('R', sign * x, {0, 0, n[3]}),
                joint('R', y, {n[4], 0, 0}),        joint('R', sign * x, Vector3d::Zero())};
  arm.tool_xyz = {n[5], 0, 0};
  arm.tool_rpy = {0, 90, 0};
  return arm;
}

Arm seven(const Numbers& n) {
  Arm arm;
  arm.joints = {joint('R', z, {0, 0, n[0] / 2}),
                joint('R', z, {0, 0, n[0] / 2}, {90, 0, 180}),
                joint('R', z, {0, n[1] / 2, 0}, {90, 0, 180}),
                joint('R', z, {0, 0, n[1] / 2}, {90, 0, 0}),
                joint('R', z, {0, n[2] / 2, 0}, {-90, 180, 0}),
                joint('R', z, {0, 0, n[2] / 2}, {90, 0, 0}),
                joint('R', z, Vector3d::Zero(), {-90, 180, 0})};
  arm.tool_xyz = {0, 0, n[3]};
  return arm;
}

Arm scara(const Numbers& n) {
  Arm arm;
  arm.joints = {joint('R', z, {0, 0, n[0]}), joint('R', z, {n[1], 0, 0}), joint('P', -z, {n[2], 0, 0}),
                joint('R', -z, {0, 0, -n[3] / 2})};
  arm.tool_rpy = {180, 0, 0};
  return arm;
}

Vector3d axis(const std::string& text) {
  if (text.size() == 2) return (text[0] == '-' ? -1 : 1) * Vector3d::Unit(text[1] - 'x');
  Vector3d v;
  char comma = ' ';
  if (!(std::istringstream(text) >> v[0] >> comma >> v[1] >> comma >> v[2])) throw std::runtime_error(text);
  return v;
}

Numbers numbers(std::istream& line) {
  Numbers result;
  for (double number = 0; line >> number;) result.push_back(number);
  return result;
}

/// A joint or the tool of the last arm.
void add_row(Arm& arm, const std::string& kind, std::istream& line) {
  std::string direction;
  if (kind != "T") line >> direction;
  const Numbers n = numbers(line);
  if (n.size() != 6) throw std::runtime_error("six numbers are wanted");
  const Vector3d xyz(n[0], n[1], n[2]), rpy(n[3], n[4], n[5]);
  if (kind == "T") {
    arm.tool_xyz = xyz;
    arm.tool_rpy = rpy;
  } else {
    arm.joints.push_back(joint(kind[0], axis(direction), xyz, rpy));
  }
}

Arm family(const std::string& kind, Numbers n) {
  static const std::map<std::string, std::size_t> sizes{{"ur", 7},    {"six", 7},   {"kuka", 7},
                                                        {"seven", 5}, {"scara", 5}, {"arm", 1}};
  if (n.size() != sizes.at(kind)) throw std::runtime_error("too many or too few numbers");
  Arm arm;
  if (kind == "ur") arm = ur(n);
  if (kind == "six") arm = six(n, 1);
  if (kind == "kuka") arm = six(n, -1);
  if (kind == "seven") arm = seven(n);
  if (kind == "scara") arm = scara(n);
  arm.mass = n.back();
  return arm;
}

}  // namespace

std::vector<Arm> read_table(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Arm> arms;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string kind;
    if (!(line >> kind) || kind[0] == '#') continue;
    try {
      if (kind == "R" || kind == "P" || kind == "T") {
        add_row(arms.at(arms.size() - 1), kind, line);
      } else {
        std::string name;
        line >> name;
        arms.push_back(family(kind, numbers(line)));
        arms.back().name = name;
      }
    } catch (const std::exception& error) {
      throw std::runtime_error(path.string() + ": " + text + ": " + error.what());
    }
  }
  return arms;
}

}  // namespace arms
